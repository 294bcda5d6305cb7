// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case/parts.hpp"

#include <algorithm>
#include <cmath>

namespace gyro {
namespace {

Vec3d vector_of(const Setting& setting) {
  return {setting.numbers.at(0), setting.numbers.at(1), setting.numbers.at(2)};
}

Vec3d direction_of(const Setting& setting) {
  const Vec3d v = vector_of(setting);
  return (1 / norm(v)) * v;
}

std::optional<double> number_if(const Setting& section, std::string_view path) {
  const Setting* setting = section.find(path);
  return setting == nullptr || setting->numbers.empty() ? std::nullopt : std::optional<double>(setting->numbers[0]);
}

CaseNumerics numerics_of(const Setting& root) {
  CaseNumerics numerics;
  numerics.precision = root.text("numerics.precision") == "double" ? Precision::double_ : Precision::mixed;
  numerics.substeps = static_cast<int>(root.number("numerics.substeps"));
  numerics.hold = number_if(root, "numerics.hold");
  if (!numerics.hold && root.text("numerics.hold") == "auto" && numerics.substeps == 1) numerics.hold = 0;
  if (const std::string level = root.text("numerics.levels.rigid"); level != "off") {
    CaseRigidRocks rigid;
    rigid.pieces = level == "pieces";
    rigid.bonded_above = root.number("numerics.levels.bonded_above");
    rigid.rigid_below = root.number("numerics.levels.rigid_below");
    rigid.calm_time = root.number("numerics.levels.calm_time");
    numerics.rigid = rigid;
  }
  return numerics;
}

template <class Named>
Index index_of(const std::vector<Named>& things, std::string_view name) {
  const auto found = std::find_if(things.begin(), things.end(), [&](const Named& thing) { return thing.name == name; });
  return found == things.end() ? none : static_cast<Index>(found - things.begin());
}

std::vector<Material> materials_of(const Setting& section) {
  std::vector<Material> materials;
  for (const Setting& m : section.children)
    materials.push_back({m.name, m.number("density"), m.number("shear_modulus"), m.number("poisson_ratio")});
  return materials;
}

/// Position of a word in a list `a|b`, whose words are in the order of an enum.
int place_in(const char* words, const std::string& word) {
  const std::vector<std::string_view> all = split(words, '|');
  return static_cast<int>(std::find(all.begin(), all.end(), word) - all.begin());
}

ContactModel model_of(const Setting& pair) {
  return {NormalModel{place_in(normal_model_words, pair.text("normal"))},
          RollingModel{place_in(rolling_model_words, pair.text("rolling"))}};
}

/// Fills the numbers of a law from the keys of the same names that the section has, and the words of a contact law.
struct ReadLaw {
  const Setting& section;

  void operator()(const char* name, double& value) const {
    if (const auto number = number_if(section, name)) value = *number;
  }
  void operator()(const char*, ContactModel& model) const { model = model_of(section); }
};

std::vector<CaseContact> contacts_of(const Setting& section, const std::vector<Material>& materials) {
  std::vector<CaseContact> contacts;
  for (const Setting& pair : section.children) {
    const std::size_t slash = pair.name.find('/');
    PairProperties properties;
    PairProperties::for_each_field(ReadLaw{pair}, properties);
    contacts.push_back({index_of(materials, pair.name.substr(0, slash)),
                        index_of(materials, pair.name.substr(slash + 1)), properties});
  }
  return contacts;
}

StrengthScatter scatter_of(const Setting& section) {
  const std::string& distribution = section.text("distribution");
  if (distribution == "weibull") return WeibullStrength{section.number("mean"), section.number("modulus")};
  const std::vector<double>& range = section.find("range")->numbers;
  if (distribution == "paper_literal") return paper_literal(range[0], range[1]);
  return TruncatedNormal{section.number("mean"), section.number("deviation"), range[0], range[1]};
}

/// With a modulus, k_n = modulus/L0 and k_s = k_n/stiffness_ratio, so that the stiffness of a rock does not depend on
/// the size of its particles.
BondParameters bond_parameters_of(const Setting& section) {
  BondParameters parameters;
  BondParameters::for_each_field(ReadLaw{section}, parameters);
  if (const auto modulus = number_if(section, "modulus")) {
    parameters.normal_modulus = *modulus;
    parameters.shear_modulus = *modulus / section.number("stiffness_ratio");
  }
  if (const auto angle = number_if(section, "friction_angle")) parameters.internal_friction = std::tan(*angle);
  return parameters;
}

CaseBonds bonds_of(const Setting& section) {
  CaseBonds bonds;
  bonds.rule.gap = section.number("gap");
  if (const auto factor = number_if(section, "radius.relative"))
    bonds.rule.radius = RelativeBondRadius{*factor};
  else if (const auto area = number_if(section, "radius.area"))
    bonds.rule.radius = ContactAreaBond{*area};
  else
    bonds.rule.radius = AbsoluteBondRadius{section.number("radius.absolute")};
  bonds.parameters = bond_parameters_of(section);
  bonds.model = {BondFailure{place_in(bond_failure_words, section.text("failure"))}};
  if (const Setting* scatter = section.find("strength_scatter")) bonds.scatter = scatter_of(*scatter);
  return bonds;
}

SizeLaw sizes_of(const Setting& section, const CaseTables& tables) {
  if (const Setting* law = section.find("rosin_rammler"))
    return RosinRammler{law->number("x63"), law->number("m"), law->number("min"), law->number("max")};
  if (const Setting* law = section.find("gates_gaudin_schuhmann"))
    return GatesGaudinSchuhmann{law->number("xmax"), law->number("m"), law->number("min")};
  if (const Setting* law = section.find("vendor")) return vendor_feed(law->number("feed_opening"), law->number("min"));
  PassingTable table{tables.sieves};
  if (const Setting* passing = section.find("passing"))
    for (std::size_t k = 0; k + 1 < passing->numbers.size(); k += 2)
      table.points.push_back({passing->numbers[k], passing->numbers[k + 1]});
  return table;
}

ShapeStyle style_of(const Setting& section) {
  ShapeStyle style;
  if (const Setting* ratio = section.find("elongation")) style.elongation = {ratio->numbers[0], ratio->numbers[1]};
  if (const Setting* ratio = section.find("flatness")) style.flatness = {ratio->numbers[0], ratio->numbers[1]};
  style.angularity = number_if(section, "angularity").value_or(style.angularity);
  style.roughness = number_if(section, "roughness").value_or(style.roughness);
  return style;
}

MonoFill mono_fill_of(const Setting& section) {
  const Setting* surface = section.find("surface");
  const bool smooth = surface != nullptr && surface->texts[0] == "smooth";
  return {section.number("ratio"), smooth ? MonoFill::Surface::smooth : MonoFill::Surface::cut,
          number_if(section, "floor").value_or(0)};
}

CaseRocks rocks_of(const Setting& section, const CaseTables& tables) {
  CaseRocks rocks;
  if (const Setting* files = section.find("shapes.files"))
    rocks.shapes = ShapeFiles{files->texts, static_cast<int>(number_if(section, "shapes.corners").value_or(0))};
  else if (const auto slenderness = number_if(section, "shapes.cylinder"))
    rocks.shapes = CylinderSpecimen{*slenderness, number_if(section, "shapes.loading_angle").value_or(0)};
  else
    rocks.shapes =
        ProceduralShapes{static_cast<int>(section.number("shapes.procedural")), style_of(*section.find("shapes"))};
  rocks.sizes = sizes_of(*section.find("sizes"), tables);
  rocks.samples = static_cast<int>(section.number("samples"));
  if (const Setting* sizes = section.find("fill.sizes"))
    rocks.fill = RangeFill{sizes->numbers[0], sizes->numbers[1], section.number("fill.exponent")};
  else
    rocks.fill = mono_fill_of(*section.find("fill"));
  rocks.density_compensated = section.text("density") == "compensated";
  return rocks;
}

CaseFeed feed_of(const Setting& section, const std::vector<CaseWall>& walls) {
  CaseFeed feed;
  feed.initial = number_if(section, "initial").value_or(0);
  feed.initial_top = number_if(section, "initial_top");
  if (const Setting* from = section.find("initial_from")) feed.initial_from = from->texts.at(0);
  feed.rate = number_if(section, "rate").value_or(0);
  feed.start = section.number("start");
  feed.mass = number_if(section, "mass");
  feed.rocks = static_cast<int>(number_if(section, "rocks").value_or(0));
  if (const Setting* at = section.find("at")) feed.at = vector_of(*at);
  if (const Setting* above = section.find("above")) feed.above = index_of(walls, above->texts.at(0));
  return feed;
}

CaseCrusher crusher_of(const Setting& section, const CaseTables& tables) {
  CaseCrusher crusher;
  if (const Setting* profile = section.find("profile")) crusher.profile = profile->texts.at(0);
  crusher.liners = tables.liners;
  crusher.closed_side_setting = section.number("closed_side_setting");
  crusher.eccentricity = section.number("eccentricity");
  crusher.pivot_height = section.number("pivot_height");
  crusher.removal_depth = number_if(section, "removal_depth");
  crusher.lid = number_if(section, "lid");
  return crusher;
}

MeshFrame frame_of(const Setting& wall) {
  MeshFrame frame;
  frame.scale = number_if(wall, "scale").value_or(1);
  if (const Setting* rotate = wall.find("rotate")) frame.rotate = vector_of(*rotate);
  if (const Setting* shift = wall.find("shift")) frame.shift = vector_of(*shift);
  return frame;
}

CaseWall wall_of(const Setting& section, const Case& made) {
  CaseWall wall;
  wall.name = section.name;
  wall.material = index_of(made.materials, section.text("material"));
  if (const Setting* plane = section.find("plane"))
    wall.shape = PlaneShape{vector_of(*plane->find("point")), direction_of(*plane->find("normal"))};
  else if (const Setting* mesh = section.find("stl"))
    wall.shape = MeshFile{mesh->texts.at(0), frame_of(section)};
  else
    wall.shape = ProfileLiner{wall.name == "mantle"};

  const Setting& motion = *section.find("motion");
  if (!motion.texts.empty()) {
    if (motion.texts[0] == "gyration")
      wall.motion = GyrationMotion{made.crusher->eccentricity, made.crusher->pivot_height};
  } else if (const Setting* velocity = motion.find("linear")) {
    wall.motion = LinearMotion{vector_of(*velocity)};
  } else if (const Setting* turn = motion.find("rotation")) {
    wall.motion =
        RotationMotion{direction_of(*turn->find("axis")), vector_of(*turn->find("point")), turn->number("speed")};
  } else if (const Setting* circle = motion.find("circular")) {
    wall.motion = CircularMotion{circle->number("radius"), circle->number("period")};
  }
  return wall;
}

CaseParticles particles_of(const Setting& section, const CaseTables& tables) {
  CaseParticles particles{section.text("file"), {}, tables.particles, tables.bonds};
  if (const Setting* bonds = section.find("bonds")) particles.bonds_file = bonds->texts.at(0);
  return particles;
}

CaseLaboratory laboratory_of(const Setting& section, const std::vector<CaseWall>& walls) {
  using Test = CaseLaboratory::Test;
  const std::string& test = section.text("test");
  return {test == "platen"      ? Test::platen
          : test == "brazilian" ? Test::brazilian
                                : Test::uniaxial,
          index_of(walls, section.text("fixed")), index_of(walls, section.text("moving"))};
}

FinesLaw fines_of(const Setting& section) {
  if (const Setting* ore = section.find("breakage"))
    return BreakageFines{ore->number("A"), ore->number("b"), ore->number("released_share")};
  return SchuhmannFines{section.number("gates_gaudin_schuhmann.m")};
}

CaseOutput output_of(const Setting& section) {
  const std::vector<std::string>& formats = section.find("formats")->texts;
  const auto has = [&](std::string_view format) {
    return std::find(formats.begin(), formats.end(), format) != formats.end();
  };
  CaseOutput output{section.number("series"),
                    section.number("snapshots"),
                    section.number("checkpoints"),
                    has("vtp"),
                    has("hdf5"),
                    std::nullopt};
  if (const Setting* maps = section.find("liners"))
    output.liners = CaseLinerMaps{maps->number("interval"), static_cast<int>(maps->number("rows")),
                                  static_cast<int>(maps->number("sectors")), number_if(*maps, "wear_coefficient")};
  if (const Setting* probes = section.find("probes"))
    for (const double id : probes->numbers) output.probes.push_back(static_cast<std::uint32_t>(id));
  if (const Setting* sieves = section.find("sieves")) output.sieves = sieves->numbers;
  if (const Setting* fines = section.find("fines")) output.fines = fines_of(*fines);
  return output;
}

}  // namespace

Case build_case(const Setting& root, const CaseTables& tables) {
  Case made;
  made.identity = {root.text("case.title"), static_cast<std::uint64_t>(root.number("case.seed"))};
  made.time = {root.number("time.duration"), number_if(root, "time.step"), root.number("time.safety")};
  made.materials = materials_of(*root.find("materials"));
  made.rock_material = index_of(made.materials, "rock");
  if (const Setting* contacts = root.find("contacts")) made.contacts = contacts_of(*contacts, made.materials);
  if (const Setting* bonds = root.find("bonds")) made.bonds = bonds_of(*bonds);
  if (const Setting* rocks = root.find("rocks")) made.rocks = rocks_of(*rocks, tables);
  if (const Setting* crusher = root.find("crusher")) made.crusher = crusher_of(*crusher, tables);
  if (const Setting* walls = root.find("walls"))
    for (const Setting& wall : walls->children) made.walls.push_back(wall_of(wall, made));
  if (const Setting* feed = root.find("feed")) made.feed = feed_of(*feed, made.walls);
  made.drivetrain_fmu = tables.fmu;
  if (const Setting* drive = root.find("drivetrain"); drive != nullptr && !tables.fmu)
    made.drivetrain = build_drivetrain(*drive, tables, *made.crusher);
  made.coupling_interval = root.number("coupling.interval");
  if (made.drivetrain) made.drivetrain->residual_limit = root.number("coupling.residual_limit");
  if (made.drivetrain_fmu) made.drivetrain_fmu->residual_limit = root.number("coupling.residual_limit");
  made.gravity = vector_of(*root.find("gravity"));
  made.numerics = numerics_of(root);
  if (const Setting* particles = root.find("particles")) made.particles = particles_of(*particles, tables);
  if (const Setting* laboratory = root.find("laboratory")) made.laboratory = laboratory_of(*laboratory, made.walls);
  made.output = output_of(*root.find("output"));
  return made;
}

}  // namespace gyro
