// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/errors.hpp"
#include "io/case/parts.hpp"
#include "io/schema/values.hpp"

#include <algorithm>

namespace gyro {
namespace {

/// Names of the settings of a section.
std::vector<std::string_view> names_in(const Setting* section) {
  std::vector<std::string_view> names;
  if (section != nullptr)
    for (const Setting& child : section->children) names.push_back(child.name);
  return names;
}

/// Whether a name that the user gave exists in a section; reports a problem if it does not.
bool expect_name(const Setting* section, const std::string& name, const std::string& what, Mark mark,
                 CaseProblems& log) {
  const std::vector<std::string_view> names = names_in(section);
  if (std::find(names.begin(), names.end(), name) != names.end()) return true;
  const std::string_view meant = closest(name, names);
  log.add(mark, "there is no " + what + " " + in_quotes(name) + "; " +
                    (meant.empty() ? "" : "did you mean " + in_quotes(meant) + "? ") +
                    (names.empty() ? "define one" : "use " + choice(names)));
  return false;
}

/// A pair that names a rolling law needs rolling friction: without it the law would have no effect.
void check_rolling(const Setting& pair, CaseProblems& log) {
  const Setting *law = pair.find("rolling"), *friction = pair.find("rolling_friction");
  if (law == nullptr || !law->given || law->texts[0] == "constant") return;
  if (friction == nullptr || friction->numbers[0] > 0) return;
  log.add(law->mark, "rolling: " + law->texts[0] + " has no effect without friction; give rolling_friction above 0");
}

/// Pairs that can touch must have surface properties; each pair is given once.
void check_contacts(const Setting& root, CaseProblems& log) {
  constexpr std::size_t max_materials = 1000;  // their pairs are a square table
  const Setting* materials = root.find("materials");
  const Setting* contacts = root.find("contacts");
  if (materials != nullptr && materials->children.size() > max_materials)
    return log.add(materials->mark,
                   "there are " + std::to_string(materials->children.size()) + " materials; give at most 1000");
  if (materials == nullptr || (contacts == nullptr && !root.lacks("contacts"))) return;
  if (materials->find("rock") == nullptr)
    log.add(materials->mark, "there is no material \"rock\", of which all particles are made; add one to materials");
  std::vector<std::pair<std::string, std::string>> given;
  bool all_known = contacts == nullptr || contacts->lost.empty();
  for (const Setting& contact : contacts == nullptr ? std::vector<Setting>{} : contacts->children) {
    const std::size_t slash = contact.name.find('/');
    const std::string a = contact.name.substr(0, slash), b = contact.name.substr(slash + 1);
    all_known &= expect_name(materials, a, "material", contact.mark, log);
    if (b != a) all_known &= expect_name(materials, b, "material", contact.mark, log);
    const std::pair<std::string, std::string> pair = std::minmax(a, b);
    if (std::find(given.begin(), given.end(), pair) != given.end())
      log.add(contact.mark, "the pair " + in_quotes(contact.name) + " is given in both orders; give it once");
    given.push_back(pair);
    check_rolling(contact, log);
  }
  // A misspelt pair is probably the one that seems to be missing. Without particles there are no contacts.
  if (!all_known || (root.find("feed") == nullptr && root.find("particles") == nullptr)) return;
  std::vector<std::string> partners = {"rock"};
  if (const Setting* walls = root.find("walls"))
    for (const Setting& wall : walls->children)
      if (const Setting* material = wall.find("material")) partners.push_back(material->texts[0]);
  std::sort(partners.begin(), partners.end());
  partners.erase(std::unique(partners.begin(), partners.end()), partners.end());
  for (const std::string& partner : partners) {
    const std::pair<std::string, std::string> pair = std::minmax<std::string>("rock", partner);
    if (materials->find(partner) != nullptr && std::find(given.begin(), given.end(), pair) == given.end())
      log.add(
          contacts != nullptr ? contacts->mark : root.mark,
          "contacts lacks \"rock/" + partner + "\", a pair that can touch; add it with its friction and restitution");
  }
}

/// Whether a wall is made of a material.
bool is_wall_material(const Setting& root, const std::string& material) {
  const Setting* walls = root.find("walls");
  return walls != nullptr && std::any_of(walls->children.begin(), walls->children.end(), [&](const Setting& wall) {
           return wall.find("material") != nullptr && wall.text("material") == material;
         });
}

/// All pairs of rock and a wall must have the same contact law. The rolling law of a pair without rolling friction does
/// not matter.
void check_wall_laws(const Setting& root, CaseProblems& log) {
  const Setting* contacts = root.find("contacts");
  if (contacts == nullptr) return;
  const Setting *normal = nullptr, *rolling = nullptr;
  const auto expect_same = [&](const Setting* law, const Setting*& first) {
    if (law == nullptr) return;
    if (first == nullptr) first = law;
    if (first->texts[0] != law->texts[0])
      log.add(law->mark, "another pair of rock and a wall has " + law->name + ": " + first->texts[0] +
                             "; give all pairs of rock and a wall the same law");
  };
  for (const Setting& pair : contacts->children) {
    const std::size_t slash = pair.name.find('/');
    const std::string a = pair.name.substr(0, slash), b = pair.name.substr(slash + 1);
    if (a != "rock" && b != "rock") continue;
    if (!is_wall_material(root, a == "rock" ? b : a)) continue;
    expect_same(pair.find("normal"), normal);
    const Setting* friction = pair.find("rolling_friction");
    if (friction != nullptr && friction->numbers[0] > 0) expect_same(pair.find("rolling"), rolling);
  }
}

void expect_direction(const Setting* vector, const std::string& what, CaseProblems& log) {
  if (vector == nullptr) return;
  const std::vector<double>& v = vector->numbers;
  if (v[0] == 0 && v[1] == 0 && v[2] == 0)
    log.add(vector->mark, what + " has no direction; give a vector other than [0, 0, 0]");
}

void check_shape(const Setting& wall, bool profile, CaseProblems& log) {
  const bool mesh = wall.find("stl") != nullptr, plane = wall.find("plane") != nullptr;
  if (profile && (wall.name == "concave" || wall.name == "mantle")) {
    if (mesh || plane)
      log.add((mesh ? wall.find("stl") : wall.find("plane"))->mark,
              "walls." + wall.name + " has two shapes, this one and crusher.profile; give exactly one of them");
    return;
  }
  if (mesh == plane && (mesh || (wall.lacks("stl") && wall.lacks("plane"))))
    log.add(wall.mark, "walls." + wall.name + (mesh ? " has two shapes" : " has no shape") +
                           "; give exactly one of stl and plane");
}

void check_walls(const Setting& root, CaseProblems& log) {
  const Setting* walls = root.find("walls");
  if (walls == nullptr) return;
  const bool profile = root.find("crusher.profile") != nullptr;
  for (const Setting& wall : walls->children) {
    if (const Setting* material = wall.find("material"); material != nullptr && root.find("materials") != nullptr)
      expect_name(root.find("materials"), material->texts[0], "material", material->mark, log);
    check_shape(wall, profile, log);
    expect_direction(wall.find("plane.normal"), "plane.normal", log);
    expect_direction(wall.find("motion.rotation.axis"), "rotation.axis", log);
    const Setting* motion = wall.find("motion");
    const bool gyrates = motion != nullptr && !motion->texts.empty() && motion->texts[0] == "gyration";
    if (gyrates && root.lacks("crusher"))
      log.add(motion->mark, "motion: gyration needs the section crusher; add it, or use motion: fixed");
    if (gyrates && wall.find("plane") != nullptr)
      log.add(motion->mark, "a plane cannot gyrate; take the wall from stl or from crusher.profile");
  }
}

/// Checks that the values of a motor are consistent.
void check_motor(const Setting& motor, CaseProblems& log) {
  const auto number = [&](std::string_view key) {
    const Setting* setting = motor.find(key);
    return setting == nullptr ? 0 : setting->numbers.at(0);
  };
  if (const Setting* voltage = motor.find("voltage"); voltage != nullptr && motor.find("voltage_file") != nullptr)
    log.add(voltage->mark, "voltage and voltage_file exclude each other; give only one of them");
  const Setting* model = motor.find("model");
  if (model == nullptr || model->texts[0] != "double_cage") return;
  const DoubleCageMotor plate{number("rated_power"), number("synchronous_speed"), number("rated_slip"),
                              number("breakdown_ratio"), number("starting_ratio")};
  if (!(plate.rated_power > 0 && plate.synchronous_speed > 0 && plate.rated_slip > 0 && plate.breakdown_ratio > 0 &&
        plate.starting_ratio > 0))
    return;  // already reported
  try {
    solve_cages(plate);
  } catch (const BadInput& problem) {
    log.add(motor.mark, problem.what());
  }
}

void check_machine(const Setting& root, CaseProblems& log) {
  if (const Setting* crusher = root.find("crusher")) {
    const Setting* arm = crusher->find("eccentricity");
    const Setting* pivot = crusher->find("pivot_height");
    if (arm != nullptr && pivot != nullptr && arm->numbers[0] >= pivot->numbers[0])
      log.add(arm->mark, "eccentricity is not smaller than pivot_height; give a smaller eccentricity");
    if (const Setting* lid = crusher->find("lid"); lid != nullptr && root.find("walls.lid") != nullptr)
      log.add(lid->mark,
              "crusher.lid makes a wall called lid, but walls has one; rename that, or leave out one of them");
  }
  const Setting* drive = root.find("drivetrain");
  if (drive == nullptr) return;
  if (root.lacks("crusher")) log.add(drive->mark, "drivetrain has no crusher to turn; add the section crusher");
  if (const Setting* motor = drive->find("motor")) check_motor(*motor, log);
  const Setting* model = drive->find("motor.model");
  const bool constant = model != nullptr && model->texts[0] == "constant_speed";
  const Setting* motor = drive->find("inertia.motor");
  const Setting* eccentric = drive->find("inertia.eccentric");
  if (model != nullptr && !constant && motor != nullptr && eccentric != nullptr &&
      motor->numbers[0] + eccentric->numbers[0] == 0)
    log.add(drive->mark, "drivetrain.inertia is zero; inertia.motor or inertia.eccentric must be > 0");
  if (const Setting* start = drive->find("start"); constant && start != nullptr && start->texts[0] == "rest")
    log.add(start->mark, "a motor of constant speed cannot start from rest; use start: running");
}

/// A hold-up that is taken over is the whole charge of a crusher.
void check_initial_from(const Setting& root, const Setting& feed, CaseProblems& log) {
  const Setting* from = feed.find("initial_from");
  if (from == nullptr) return;
  for (const char* key : {"initial", "initial_top"})
    if (const Setting* extra = feed.find(key))
      log.add(extra->mark, std::string("feed.") + key + " cannot be combined with feed.initial_from; give one of them");
  if (root.lacks("crusher"))
    log.add(from->mark, "feed.initial_from fills the chamber of a crusher; add the section crusher, or use particles");
}

/// Checks that the feed has exactly one of its three forms.
void check_feed(const Setting& root, CaseProblems& log) {
  const Setting* feed = root.find("feed");
  if (feed == nullptr) return;
  if (root.lacks("rocks")) log.add(feed->mark, "feed has no rocks to draw from; add the section rocks");
  const auto has = [&](std::string_view key) { return feed->find(key) != nullptr; };
  const auto refuse = [&](const std::string& form, std::initializer_list<std::string_view> others) {
    for (const std::string_view other : others)
      if (const Setting* extra = feed->find(other); extra != nullptr && extra->given)
        log.add(extra->mark, "feed." + std::string(other) + " cannot be combined with feed." + form +
                                 "; give exactly one of: initial with rate, mass, or rocks with at");
  };
  if (has("rocks") || has("at")) {
    refuse(has("rocks") ? "rocks" : "at", {"initial", "initial_from", "initial_top", "rate", "mass", "above"});
    if (const Setting* start = feed->find("start"); start != nullptr && start->numbers[0] != 0)
      log.add(start->mark, "placed rocks are present from t = 0; remove feed.start");
    if (feed->lacks("rocks") || feed->lacks("at"))
      log.add(feed->mark, "feed.rocks and feed.at belong together; give both");
    return;
  }
  check_initial_from(root, *feed, log);
  if (has("mass")) {
    refuse("mass", {"initial", "initial_from", "initial_top", "rate"});
  } else if (feed->lacks("initial") && feed->lacks("initial_from") && feed->lacks("rate") && feed->lacks("mass")) {
    log.add(feed->mark, "feed has no amount; give exactly one of: initial with rate, mass, or rocks with at");
  }
  if (const Setting* above = feed->find("above")) {
    if (!expect_name(root.find("walls"), above->texts[0], "wall", above->mark, log)) return;
    if (root.find("walls")->find(above->texts[0])->find("plane") != nullptr)
      log.add(above->mark, "a plane has no opening to feed above; name a wall from stl or from crusher.profile");
  } else if (feed->lacks("above")) {
    log.add(feed->mark, "feed does not say above which wall; set feed.above to a name from walls");
  }
}

/// Checks that one size of a size law is smaller than another.
void expect_order(const Setting& root, std::string_view section, std::string_view small, std::string_view large,
                  CaseProblems& log) {
  const Setting* law = root.find(section);
  const Setting* a = law == nullptr ? nullptr : law->find(small);
  const Setting* b = law == nullptr ? nullptr : law->find(large);
  if (a != nullptr && b != nullptr && !(a->numbers[0] < b->numbers[0]))
    log.add(a->mark, std::string(small) + " is not smaller than " + std::string(large) + "; give a smaller size");
}

/// Refuses keys that belong to the form `other` of a section if the section has the form `form`.
void refuse_beside(const Setting& root, const std::string& section, const std::string& form, const std::string& other,
                   std::initializer_list<const char*> keys, CaseProblems& log) {
  const Setting* said = root.find(section);
  if (said == nullptr || said->find(form) == nullptr) return;
  for (const char* key : keys) {
    if (const Setting* extra = said->find(key))
      log.add(extra->mark, section + "." + key + " cannot be combined with " + section + "." + form +
                               "; it belongs to " + section + "." + other);
  }
}

void check_rocks(const Setting& root, CaseProblems& log) {
  expect_order(root, "rocks.sizes.rosin_rammler", "min", "max", log);
  expect_order(root, "rocks.sizes.gates_gaudin_schuhmann", "min", "xmax", log);
  const Setting* minimum = root.find("rocks.sizes.vendor.min");
  const Setting* opening = root.find("rocks.sizes.vendor.feed_opening");
  if (minimum != nullptr && opening != nullptr && !(minimum->numbers[0] < 0.1 * opening->numbers[0]))
    log.add(minimum->mark,
            "min is not below 0.1 of feed_opening, the size that half of the feed passes; give a smaller size");
  if (const Setting* passing = root.find("rocks.sizes.passing")) {
    const std::vector<double>& v = passing->numbers;
    for (std::size_t k = 2; k + 1 < v.size(); k += 2) {
      if (!(v[k] > v[k - 2]))
        log.add(passing->item_marks[k], "sizes do not rise; each size must be larger than the one before");
      if (v[k + 1] < v[k - 1])
        log.add(passing->item_marks[k + 1], "passing falls; each share must be >= the one before");
    }
    if (v[1] != 0)
      log.add(passing->item_marks[1], "the share that passes the smallest size is not 0; the first share must be 0");
    if (v.back() != 1)
      log.add(passing->item_marks.back(), "the share that passes the largest size is not 1; the last share must be 1");
  }
  refuse_beside(root, "rocks.fill", "ratio", "sizes", {"exponent"}, log);
  refuse_beside(root, "rocks.fill", "sizes", "ratio", {"surface", "floor"}, log);
  refuse_beside(root, "rocks.shapes", "files", "cylinder", {"loading_angle"}, log);
  refuse_beside(root, "rocks.shapes", "procedural", "cylinder", {"loading_angle"}, log);
  refuse_beside(root, "rocks.shapes", "files", "procedural", {"elongation", "flatness", "angularity", "roughness"},
                log);
  refuse_beside(root, "rocks.shapes", "procedural", "files", {"corners"}, log);
  const Setting* scatter = root.find("bonds.strength_scatter");
  const Setting* mean = scatter == nullptr ? nullptr : scatter->find("mean");
  const Setting* range = scatter == nullptr ? nullptr : scatter->find("range");
  const double middle = mean == nullptr ? 1 : mean->numbers[0];  // paper_literal has the mean 1 and no key for it
  if (range != nullptr && scatter->lost.empty() && (middle < range->numbers[0] || middle > range->numbers[1]))
    log.add(range->mark, "the mean of strength_scatter is not inside the range; give a range that contains it");
}

/// Checks that a laboratory test has bonds, two planes of which one moves along a line, and a cylinder if the test
/// needs one.
void check_laboratory(const Setting& root, CaseProblems& log) {
  const Setting* laboratory = root.find("laboratory");
  if (laboratory == nullptr) return;
  if (root.find("crusher") != nullptr)
    log.add(laboratory->mark, "laboratory measures one rock, not a crusher; leave out one of the two sections");
  if (root.find("bonds") == nullptr)
    log.add(laboratory->mark, "laboratory measures the breakage of bonds; add the section bonds");
  for (const char* key : {"fixed", "moving"}) {
    const Setting* name = laboratory->find(key);
    if (name == nullptr || !expect_name(root.find("walls"), name->texts[0], "wall", name->mark, log)) continue;
    const Setting& wall = *root.find("walls")->find(name->texts[0]);
    if (wall.find("plane") == nullptr) log.add(name->mark, "a platen must be a plane; name a wall with plane");
    if (std::string_view(key) == "moving" && wall.find("motion.linear") == nullptr)
      log.add(name->mark, "the moving platen does not move; name a wall with motion: {linear: ...}");
  }
  const Setting *fixed = laboratory->find("fixed"), *moving = laboratory->find("moving");
  if (fixed != nullptr && moving != nullptr && fixed->texts[0] == moving->texts[0])
    log.add(moving->mark, "fixed and moving are the same wall; name two platens");
  const Setting* test = laboratory->find("test");
  if (test != nullptr && test->texts[0] != "platen" && root.find("rocks.shapes.cylinder") == nullptr)
    log.add(test->mark, "a " + test->texts[0] + " test needs a cylinder; use rocks.shapes.cylinder");
}

/// Rocks can only be rigid where there are bonds, and must not become bonded and rigid at the same load.
void check_levels(const Setting& root, CaseProblems& log) {
  const Setting* rigid = root.find("numerics.levels.rigid");
  if (rigid == nullptr || rigid->texts.empty() || rigid->texts[0] == "off") return;
  if (root.lacks("bonds")) log.add(rigid->mark, "numerics.levels.rigid needs the section bonds; add it, or use off");
  const Setting *above = root.find("numerics.levels.bonded_above"), *below = root.find("numerics.levels.rigid_below");
  const auto value = [](const Setting* setting, double fallback) {
    return setting != nullptr && !setting->numbers.empty() ? setting->numbers[0] : fallback;
  };
  if (!(value(below, RigidLevel{}.rigid_below) < value(above, RigidLevel{}.bonded_above)))
    log.add(below != nullptr ? below->mark : above->mark,
            "rigid_below is not below bonded_above, so that rocks would change at once and back; give a smaller "
            "rigid_below or a larger bonded_above");
}

void check_run(const Setting& root, CaseProblems& log) {
  const Setting* step = root.find("time.step");
  const Setting* interval = root.find("coupling.interval");
  if (step != nullptr && !step->numbers.empty() && interval != nullptr && step->numbers[0] > interval->numbers[0])
    log.add(step->mark, "time.step is longer than coupling.interval; reduce it to coupling.interval or less");
  const Setting* hold = root.find("numerics.hold");
  if (hold != nullptr && !hold->numbers.empty()) {
    if (interval != nullptr && hold->numbers[0] > interval->numbers[0])
      log.add(hold->mark, "numerics.hold is longer than coupling.interval; reduce it to coupling.interval or less");
    if (root.number("numerics.substeps") > 1)
      log.add(hold->mark, "numerics.hold and numerics.substeps above 1 contradict each other; give one of them");
  }
  check_levels(root, log);
  const Setting* bonds = root.find("particles.bonds");
  if (bonds != nullptr && root.lacks("bonds"))
    log.add(bonds->mark, "particles.bonds needs the section bonds; add it with the stiffness and strengths");
}

/// Only broken rock that leaves a crusher has fines.
void check_fines(const Setting& root, CaseProblems& log) {
  const Setting* fines = root.find("output.fines");
  if (fines == nullptr) return;
  if (root.lacks("crusher"))
    log.add(fines->mark, "output.fines estimates the product of a crusher; add the section crusher, or remove fines");
  if (root.lacks("bonds"))
    log.add(fines->mark, "output.fines needs rock that breaks; add the section bonds, or remove fines");
}

}  // namespace

void check_settings(const Setting& root, CaseProblems& log) {
  check_contacts(root, log);
  check_wall_laws(root, log);
  check_walls(root, log);
  check_machine(root, log);
  check_feed(root, log);
  check_rocks(root, log);
  check_laboratory(root, log);
  check_run(root, log);
  check_fines(root, log);
  check_intervals(root, log);
}

}  // namespace gyro
