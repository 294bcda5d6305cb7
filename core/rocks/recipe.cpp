// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/recipe.hpp"

#include "core/base/errors.hpp"

#include <cmath>
#include <cstdio>

namespace gyro {
namespace {

/// Increase it with every change that makes different rocks from the same recipe.
constexpr int generator_version = 4;

class Text {
 public:
  void word(const std::string& key, const std::string& value) { text_ += key + " " + value + "\n"; }
  void number(const std::string& key, double value) {
    char digits[40];
    std::snprintf(digits, sizeof digits, "%a", value);
    word(key, digits);
  }
  std::string finish() { return std::move(text_); }

 private:
  std::string text_;
};

void add(Text& text, const PassingTable& law) {
  for (const auto& [size, fraction] : law.points) text.number("passing size", size), text.number("fraction", fraction);
}

void add(Text& text, const RosinRammler& law) {
  text.number("rosin_rammler x63", law.x63), text.number("exponent", law.exponent);
  text.number("smallest", law.smallest), text.number("largest", law.largest);
}

void add(Text& text, const GatesGaudinSchuhmann& law) {
  text.number("gates_gaudin_schuhmann largest", law.largest);
  text.number("exponent", law.exponent), text.number("smallest", law.smallest);
}

void add(Text& text, const ProceduralShapes& shapes) {
  text.word("procedural", std::to_string(shapes.count));
  const ShapeStyle& style = shapes.style;
  text.number("elongation from", style.elongation.low), text.number("to", style.elongation.high);
  text.number("flatness from", style.flatness.low), text.number("to", style.flatness.high);
  text.number("angularity", style.angularity), text.number("roughness", style.roughness);
}

void add(Text& text, const GivenShapes& given) {
  text.word("corners", std::to_string(given.corners));
  for (const GivenShape& shape : given.shapes) text.word("shape " + shape.name, shape.content);
}

void add(Text& text, const CylinderSpecimen& specimen) {
  text.number("cylinder", specimen.slenderness);
  if (specimen.loading_angle > 0) text.number("loading angle", specimen.loading_angle);
}

void add(Text& text, const RelativeBondRadius& radius) {
  text.number("relative bond radius", radius.factor);
}
void add(Text& text, const AbsoluteBondRadius& radius) {
  text.number("absolute bond radius", radius.radius);
}

void add(Text& text, const ContactAreaBond& rule) {
  text.number("bond area", rule.factor);
}

void add(Text& text, const MonoFill& fill) {
  text.number("fill ratio", fill.ratio);
  if (fill.surface == MonoFill::Surface::smooth) text.word("surface", "smooth");
  if (fill.floor > 0) text.number("floor", fill.floor);
}
void add(Text& text, const RangeFill& fill) {
  text.number("fill smallest", fill.smallest), text.number("largest", fill.largest);
  text.number("exponent", fill.exponent);
}

void check_not_negative(const std::string& name, double value) {
  if (!(std::isfinite(value) && value >= 0)) throw BadInput(name + " must be >= 0");
}

}  // namespace

void check_recipe(const LibraryRecipe& recipe) {
  if (const auto* procedural = std::get_if<ProceduralShapes>(&recipe.shapes)) {
    if (procedural->count < 1 || procedural->count > max_samples) {
      throw BadInput("rocks.shapes.procedural must be between 1 and " + std::to_string(max_samples));
    }
    check_style(procedural->style);
  } else if (const auto* cylinder = std::get_if<CylinderSpecimen>(&recipe.shapes)) {
    if (!(cylinder->slenderness >= 0.1 && cylinder->slenderness <= 10))
      throw BadInput("rocks.shapes.cylinder must be between 0.1 and 10");
    if (!(cylinder->loading_angle >= 0 && cylinder->loading_angle <= 1))
      throw BadInput("rocks.shapes.loading_angle must be between 0 and 1 rad");
  } else {
    const auto& given = std::get<GivenShapes>(recipe.shapes);
    if (given.shapes.empty()) throw BadInput("rocks.shapes.files is empty; name at least one STL or OBJ file");
    if (given.corners != 0 && (given.corners < 8 || given.corners > max_corners))
      throw BadInput("rocks.shapes.corners must be between 8 and " + std::to_string(max_corners));
  }
  if (recipe.samples < 1 || recipe.samples > max_samples)
    throw BadInput("rocks.samples must be between 1 and " + std::to_string(max_samples));
  check_rule(recipe.fill);
  if (!(std::isfinite(recipe.rock_density) && recipe.rock_density > 0)) {
    throw BadInput("the rock's density must be a finite number above 0");
  }
  check_rule(recipe.bond_rule);
  check_not_negative("bonds.normal_stiffness", recipe.bond_parameters.normal_stiffness);
  check_not_negative("bonds.shear_stiffness", recipe.bond_parameters.shear_stiffness);
  check_not_negative("bonds.modulus", recipe.bond_parameters.normal_modulus);
  check_not_negative("bonds.modulus / stiffness_ratio", recipe.bond_parameters.shear_modulus);
  check_not_negative("bonds.damping", recipe.bond_parameters.damping);
  for (const double value : {recipe.bed.number, recipe.bed.normal_stiffness, recipe.bed.tangential_stiffness,
                             recipe.bed.normal_damping, recipe.bed.tangential_damping}) {
    check_not_negative("every number of the bed's contacts", value);
  }
  if (!(recipe.bed.damping_cap >= 0)) throw BadInput("the cap on the damping of the bed's contacts must be >= 0");
}

std::string recipe_text(const LibraryRecipe& recipe) {
  Text text;
  text.word("gyrosim rock library", std::to_string(generator_version));
  text.word("seed", std::to_string(recipe.seed));
  std::visit([&](const auto& shapes) { add(text, shapes); }, recipe.shapes);
  std::visit([&](const auto& law) { add(text, law); }, recipe.sizes);
  text.word("samples", std::to_string(recipe.samples));
  std::visit([&](const auto& fill) { add(text, fill); }, recipe.fill);
  text.number("rock density", recipe.rock_density);
  text.word("density", recipe.compensated ? "compensated" : "plain");
  text.number("gap", recipe.bond_rule.gap);
  std::visit([&](const auto& radius) { add(text, radius); }, recipe.bond_rule.radius);
  text.number("normal stiffness", recipe.bond_parameters.normal_stiffness);
  text.number("shear stiffness", recipe.bond_parameters.shear_stiffness);
  text.number("normal modulus", recipe.bond_parameters.normal_modulus);
  text.number("shear modulus", recipe.bond_parameters.shear_modulus);
  text.number("damping", recipe.bond_parameters.damping);
  text.number("bed number", recipe.bed.number);
  text.number("bed normal stiffness", recipe.bed.normal_stiffness);
  text.number("bed tangential stiffness", recipe.bed.tangential_stiffness);
  text.number("bed normal damping", recipe.bed.normal_damping);
  text.number("bed tangential damping", recipe.bed.tangential_damping);
  text.number("bed damping cap", recipe.bed.damping_cap);
  return text.finish();
}

}  // namespace gyro
