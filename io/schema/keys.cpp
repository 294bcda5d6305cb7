// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/schema/keys.hpp"
#include "core/rocks/library.hpp"
#include "core/scene/bond_model.hpp"
#include "core/scene/contact_model.hpp"

namespace gyro {
namespace {

using enum KeyType;
using enum Dimension;

// clang-format would put every field on its own line.
// clang-format off
const std::vector<Key> identity_keys = {
    {.path = "case", .defaulted = true, .doc = "Title of the run and seed of its random numbers."},
    {.path = "case.title", .type = text, .doc = "Free text for logs and reports; the name of the file by default."},
    {.path = "case.seed", .type = integer, .fallback = "1", .range = {.low = 0, .high = 9007199254740992.0},
     .doc = "Seed of all random numbers: shapes, fillings, sizes, positions and strengths."},

    {.path = "time", .required = true, .doc = "Simulated time and time step."},
    {.path = "time.duration", .type = quantity, .dimension = Dimension::time, .required = true, .range = positive,
     .doc = "Simulated time of the run."},
    {.path = "time.step", .type = quantity, .dimension = Dimension::time, .fallback = "auto", .range = positive, .words = "auto",
     .doc = "Largest time step of bonds, and of all without bonds; auto: safety times their stability limit with damping, rounded down so that the hold of contacts "
            "is a whole number of steps; a number must not exceed safety times that limit."},
    {.path = "time.safety", .type = quantity, .fallback = "0.7", .range = {.low = 0, .high = 1, .low_open = true},
     .doc = "Largest time step / stability limit with damping; below 0.7 the hold of contacts is reduced in proportion. With a value near 1 the "
            "bonds of breaking rock become unstable."},
};

const std::vector<Key> material_keys = {
    {.path = "materials", .type = named, .required = true,
     .doc = "Elastic solids by name; `rock` is required, because all particles are made of it."},
    {.path = "materials.<name>.density", .type = quantity, .dimension = density, .required = true, .range = positive,
     .doc = "Density of the solid."},
    {.path = "materials.<name>.shear_modulus", .type = quantity, .dimension = pressure, .required = true, .range = positive,
     .doc = "Shear modulus G for contacts; Young's modulus is 2 G (1 + poisson_ratio)."},
    {.path = "materials.<name>.poisson_ratio", .type = quantity, .required = true, .range = {.low = 0, .high = 0.5, .high_open = true},
     .doc = "Poisson's ratio."},

    {.path = "contacts", .type = named,
     .doc = "Contact properties of pairs of materials, such as `rock/steel`; every pair that can touch needs an entry."},
    {.path = "contacts.<pair>.friction", .type = quantity, .required = true, .range = not_negative,
     .doc = "Coulomb friction coefficient."},
    {.path = "contacts.<pair>.restitution", .type = quantity, .required = true, .range = {.low = 0.001, .high = 1},
     .doc = "Coefficient of restitution of a normal impact of two particles; small values require small time steps."},
    {.path = "contacts.<pair>.rolling_friction", .type = quantity, .fallback = "0", .range = not_negative,
     .doc = "Largest rolling torque / (effective radius x normal force)."},
    {.path = "contacts.<pair>.normal", .type = word, .fallback = "hertz", .words = normal_model_words,
     .doc = "Normal force. hertz: Hertz's force with a dashpot; hysteretic: a linear spring that unloads more steeply than it loads. "
            "With hysteretic the time step is a quarter of the stability limit, so that the restitution is accurate to 1 %."},
    {.path = "contacts.<pair>.rolling", .type = word, .fallback = "constant", .words = rolling_model_words,
     .doc = "Rolling resistance. constant: a constant torque; spring_dashpot: a spring, limited to the same torque, and a dashpot."},

    {.path = "bonds", .one_of = "normal_stiffness+shear_stiffness|modulus+stiffness_ratio",
     .doc = "Bonds between the particles of a rock; without this section the particles are unbreakable spheres."},
    {.path = "bonds.gap", .type = quantity, .fallback = "0.05", .range = {.low = 0, .high = 1, .high_open = true},
     .doc = "Two particles are bonded if the gap between their surfaces is smaller than this number times the smaller radius."},
    {.path = "bonds.normal_stiffness", .type = quantity, .dimension = stiffness_per_area, .range = positive,
     .doc = "Normal stiffness per area of the bond's cross-section."},
    {.path = "bonds.shear_stiffness", .type = quantity, .dimension = stiffness_per_area, .range = positive,
     .doc = "Shear stiffness per area of the bond's cross-section."},
    {.path = "bonds.modulus", .type = quantity, .dimension = pressure, .range = positive,
     .doc = "Modulus of the bond, instead of the stiffnesses; normal stiffness = modulus / bond length."},
    {.path = "bonds.stiffness_ratio", .type = quantity, .range = positive,
     .doc = "With modulus: normal stiffness / shear stiffness."},
    {.path = "bonds.tensile_strength", .type = quantity, .dimension = pressure, .required = true, .range = positive,
     .doc = "Tensile stress, from tension and bending, at which a bond with strength factor 1 breaks."},
    {.path = "bonds.shear_strength", .type = quantity, .dimension = pressure, .required = true, .range = positive,
     .doc = "Shear stress, from shear and torsion, at which a bond with strength factor 1 breaks."},
    {.path = "bonds.failure", .type = word, .fallback = "constant", .words = bond_failure_words,
     .doc = "Failure criterion. constant: constant strengths; mohr_coulomb: a shear strength that increases with the compression of the bond."},
    {.path = "bonds.friction_angle", .type = quantity, .dimension = Dimension::angle, .range = {.low = 0, .high = 1.4},
     .when = "failure=mohr_coulomb",
     .doc = "Friction angle of an intact bond: compression adds tan(friction_angle) x mean compressive stress to its shear strength; "
            "this part is not multiplied by the strength factor."},
    {.path = "bonds.radius", .required = true, .one_of = "relative|absolute|area", .doc = "Radius of the cross-section of a bond."},
    {.path = "bonds.radius.relative", .type = quantity, .range = {.low = 0, .high = 2, .low_open = true},
     .doc = "Bond radius / smaller particle radius."},
    {.path = "bonds.radius.absolute", .type = quantity, .dimension = length, .range = positive, .doc = "The same radius for every bond."},
    {.path = "bonds.radius.area", .type = quantity, .range = {.low = 0, .high = 4, .low_open = true},
     .doc = "Cross-section of a bond / (pi R^2) with R = 2 Ri Rj/(Ri + Rj); the cross-section is proportional to the contact area of "
            "the two particles."},
    {.path = "bonds.strength_scatter",
     .doc = "Random factor on both strengths, drawn once for each bond; without the section every factor is 1."},
    {.path = "bonds.strength_scatter.distribution", .type = word, .required = true, .words = "truncated_normal|paper_literal|weibull",
     .doc = "truncated_normal: normal distribution, truncated to the range; paper_literal: 1 + a standard normal number, drawn again "
            "until the factor lies in the range; weibull: Weibull distribution with a modulus, without an upper limit."},
    {.path = "bonds.strength_scatter.mean", .type = quantity, .fallback = "1", .range = positive,
     .when = "distribution=truncated_normal|weibull", .doc = "Mean of the distribution; for truncated_normal, before truncation."},
    {.path = "bonds.strength_scatter.deviation", .type = quantity, .range = not_negative,
     .when = "distribution=truncated_normal", .doc = "Standard deviation before truncation."},
    {.path = "bonds.strength_scatter.range", .type = interval, .range = not_negative,
     .when = "distribution=truncated_normal|paper_literal", .doc = "Smallest and largest factor; the mean must lie between them."},
    {.path = "bonds.strength_scatter.modulus", .type = quantity, .range = positive, .when = "distribution=weibull",
     .doc = "Weibull modulus; 3 to 8 for rock, a smaller value means more scatter."},
    {.path = "bonds.damping", .type = quantity, .fallback = "0.05", .range = {.low = 0, .high = 1},
     .doc = "Damping of each mode of a bond, as a fraction of critical damping."},
};

const std::vector<Key> rock_keys = {
    {.path = "rocks", .doc = "The library of rocks (meta-particles) that the feed draws from."},
    {.path = "rocks.shapes", .required = true, .one_of = "procedural|files|cylinder", .doc = "Shapes of the rocks."},
    {.path = "rocks.shapes.procedural", .type = integer, .range = {.low = 1, .high = max_samples},
     .doc = "Number of random polyhedra, generated from the seed."},
    {.path = "rocks.shapes.files", .type = files, .doc = "Closed STL or OBJ meshes, scaled to the sizes of the size "
            "distribution; their unit, position and orientation do not matter."},
    {.path = "rocks.shapes.cylinder", .type = quantity, .range = {.low = 0.1, .high = 10},
     .doc = "Length / diameter of cylindrical test specimens; their axis is x, or z if they are shorter than 0.87 diameters."},
    {.path = "rocks.shapes.loading_angle", .type = quantity, .dimension = Dimension::angle, .range = {.low = 0, .high = 1},
     .doc = "With cylinder: angle that each of two flats on the side, facing +y and -y, subtends at the axis; no flats by default."},
    {.path = "rocks.shapes.elongation", .type = interval, .range = {.low = 0, .high = 1, .low_open = true},
     .doc = "With procedural: intermediate / long axis of a rock, uniform in this range; [0.65, 0.95] by default."},
    {.path = "rocks.shapes.flatness", .type = interval, .range = {.low = 0, .high = 1, .low_open = true},
     .doc = "With procedural: short / intermediate axis of a rock, uniform in this range; [0.65, 0.95] by default."},
    {.path = "rocks.shapes.angularity", .type = quantity, .range = {.low = 0, .high = 1},
     .doc = "With procedural: 0 gives rounded rocks, 0.5 (the default) crushed aggregate, 1 sharp-edged rocks."},
    {.path = "rocks.shapes.roughness", .type = quantity, .range = {.low = 0, .high = 0.3},
     .doc = "With procedural: deviation of the surface from the polyhedron / radius; 0 (flat faces) by default."},
    {.path = "rocks.shapes.corners", .type = integer, .range = {.low = 8, .high = max_corners},
     .doc = "With files: each scan is replaced by a convex polyhedron around it with at most this number of corners."},
    {.path = "rocks.sizes", .required = true, .one_of = "passing|rosin_rammler|gates_gaudin_schuhmann|vendor|sieves",
     .doc = "Size distribution of the feed by mass; the size of a rock is its equal-volume diameter."},
    {.path = "rocks.sizes.passing", .type = passing, .dimension = length,
     .doc = "Pairs [size, mass share of smaller rocks] with increasing sizes and with shares from 0 to 1; linear in between."},
    {.path = "rocks.sizes.rosin_rammler", .doc = "Mass share smaller than x: 1 - exp(-(x/x63)^m), truncated at min and max."},
    {.path = "rocks.sizes.rosin_rammler.x63", .type = quantity, .dimension = length, .required = true, .range = positive,
     .doc = "Size that 63.2 % of the mass passes."},
    {.path = "rocks.sizes.rosin_rammler.m", .type = quantity, .required = true, .range = positive, .doc = "Exponent."},
    {.path = "rocks.sizes.rosin_rammler.min", .type = quantity, .dimension = length, .required = true, .range = positive,
     .doc = "Smallest rock."},
    {.path = "rocks.sizes.rosin_rammler.max", .type = quantity, .dimension = length, .required = true, .range = positive,
     .doc = "Largest rock."},
    {.path = "rocks.sizes.gates_gaudin_schuhmann", .doc = "Mass share smaller than x: (x/xmax)^m, truncated at min."},
    {.path = "rocks.sizes.gates_gaudin_schuhmann.xmax", .type = quantity, .dimension = length, .required = true, .range = positive,
     .doc = "Largest rock."},
    {.path = "rocks.sizes.gates_gaudin_schuhmann.m", .type = quantity, .required = true, .range = positive, .doc = "Exponent."},
    {.path = "rocks.sizes.gates_gaudin_schuhmann.min", .type = quantity, .dimension = length, .required = true, .range = positive,
     .doc = "Smallest rock."},
    {.path = "rocks.sizes.vendor",
     .doc = "Feed for which manufacturers state capacities: 100 % of the mass is smaller than 0.8, 80 % smaller than 0.6 and 50 % smaller "
            "than 0.1 of the feed opening."},
    {.path = "rocks.sizes.vendor.feed_opening", .type = quantity, .dimension = length, .required = true, .range = positive,
     .doc = "Feed opening of the crusher."},
    {.path = "rocks.sizes.vendor.min", .type = quantity, .dimension = length, .required = true, .range = positive,
     .doc = "Smallest rock; it must be smaller than 0.1 of the opening."},
    {.path = "rocks.sizes.sieves", .type = file,
     .doc = "CSV with the header size_mm,passing_percent; the sieves may be in increasing or decreasing order; the finest must have "
            "0 and the coarsest 100 percent."},
    {.path = "rocks.samples", .type = integer, .fallback = "24", .range = {.low = 1, .high = max_samples},
     .doc = "Number of rocks in the library; each has one of the shapes and a size of its own."},
    {.path = "rocks.fill", .required = true, .one_of = "ratio|sizes", .doc = "How a rock is filled with particles."},
    {.path = "rocks.fill.ratio", .type = quantity, .range = {.low = 2, .high = 50},
     .doc = "Equal-volume diameter of the rock / particle diameter; all particles of a rock have the same size."},
    {.path = "rocks.fill.floor", .type = quantity, .dimension = length, .range = positive,
     .doc = "With ratio: smallest particle diameter in rocks that are large enough for it: max(d/ratio, min(floor, d/3)) in a rock of "
            "diameter d. Small rocks then have fewer particles, at least as many as with ratio 3; without the key none is coarsened."},
    {.path = "rocks.fill.surface", .type = word, .words = "cut|smooth",
     .doc = "With ratio: cut (the default) cuts the rock out of a packing; smooth packs particles inside the convex shape, so "
            "that its faces bear load like ground faces."},
    {.path = "rocks.fill.sizes", .type = interval, .dimension = length, .range = positive,
     .doc = "Smallest and largest particle diameter, the same for all rocks; no particle is larger than a third of its rock."},
    {.path = "rocks.fill.exponent", .type = quantity, .range = {.low = 0, .high = 5, .low_open = true},
     .doc = "With sizes: the volume share of particles smaller than x grows as x^exponent; 0.8 by default, which fills a rock of "
            "500 mm with 20,000 particles of 8 to 45 mm."},
    {.path = "rocks.density", .type = word, .fallback = "compensated", .words = "compensated|material",
     .doc = "compensated: a rock has the mass of solid rock of its shape, so that its particles are denser than materials.rock; "
            "material: particles have the density of materials.rock."},

    {.path = "feed", .doc = "Rocks that enter the scene: a continuous feed (initial, rate), a batch (mass), or rocks placed at a point (rocks, at)."},
    {.path = "feed.initial", .type = quantity, .dimension = mass, .range = not_negative, .doc = "Mass in the chamber at t = 0."},
    {.path = "feed.initial_from", .type = file,
     .doc = "Directory of another run, or its checkpoint.h5: the chamber is filled at t = 0 by what that run holds up there, in place of feed.initial. "
            "Each of its fragments is replaced, where it lies, by a connected part of this case's rocks of the same mass with intact bonds of new "
            "strengths, whole rocks by whole rocks, single particles by single particles; masses that this case's particles cannot give are carried "
            "over to the next fragment above. Positions and velocities are turned to where the mantle starts. A piece that finds no room lies above. "
            "The other run may have other liners, settings, fill, sizes and drive, but the same materials.rock."},
    {.path = "feed.initial_top", .type = quantity, .dimension = length, .doc = "Height z below which the initial charge lies."},
    {.path = "feed.rate", .type = quantity, .dimension = mass_flow, .range = not_negative, .doc = "Mass flow of the feed."},
    {.path = "feed.start", .type = quantity, .dimension = Dimension::time, .fallback = "0 s", .range = not_negative,
     .doc = "Time at which the feed starts or the batch is dropped."},
    {.path = "feed.mass", .type = quantity, .dimension = mass, .range = positive, .doc = "Mass of a single batch."},
    {.path = "feed.above", .type = text,
     .doc = "Wall (a mesh or a liner) above whose opening rocks appear; `concave` by default, if there is one."},
    {.path = "feed.rocks", .type = integer, .range = {.low = 1, .high = 1000000},
     .doc = "Number of rocks that are present at t = 0, taken from the library in order; needs at."},
    {.path = "feed.at", .type = vector, .dimension = length,
     .doc = "Centre of mass of the first of these rocks; the others are stacked above it."},
};

const std::vector<Key> wall_keys = {
    {.path = "walls", .type = named, .doc = "Rigid walls by name; `concave` and `mantle` take their shape from crusher.profile if that is given."},
    {.path = "walls.<name>.stl", .type = file,
     .doc = "Closed or open STL or OBJ mesh in metres, with z upwards along the machine's axis. A mesh with another unit or position is "
            "scaled, then rotated, then shifted by the keys scale, rotate and shift."},
    {.path = "walls.<name>.scale", .type = quantity, .range = positive, .when = "stl",
     .doc = "Factor on the coordinates of the mesh: 0.001 for a drawing in mm; 1 by default."},
    {.path = "walls.<name>.rotate", .type = vector, .dimension = Dimension::angle, .when = "stl",
     .doc = "Angles by which the scaled mesh is rotated about the fixed axes x, then y, then z, right-handed: [90 deg, 0, 0] for a "
            "drawing with y upwards; zero by default."},
    {.path = "walls.<name>.shift", .type = vector, .dimension = length, .range = {.low = -1e7, .high = 1e7}, .when = "stl",
     .doc = "Vector by which the scaled and rotated mesh is shifted, for example from mine coordinates to the origin; zero by default."},
    {.path = "walls.<name>.plane", .doc = "Infinite plane; the rock is on the side to which the normal points."},
    {.path = "walls.<name>.plane.point", .type = vector, .dimension = length, .required = true, .doc = "A point of the plane."},
    {.path = "walls.<name>.plane.normal", .type = vector, .required = true, .doc = "Normal of the plane, of any length except 0."},
    {.path = "walls.<name>.material", .type = text, .required = true, .doc = "Name of a material from materials."},
    {.path = "walls.<name>.motion", .words = "fixed|gyration", .one_of = "linear|rotation|circular",
     .doc = "Motion of the wall; fixed by default, gyration for a mantle from crusher.profile."},
    {.path = "walls.<name>.motion.linear", .type = vector, .dimension = speed, .doc = "Constant velocity."},
    {.path = "walls.<name>.motion.rotation", .doc = "Rotation about a fixed axis."},
    {.path = "walls.<name>.motion.rotation.axis", .type = vector, .required = true,
     .doc = "Direction of the axis, of any length except 0."},
    {.path = "walls.<name>.motion.rotation.point", .type = vector, .dimension = length, .required = true, .doc = "A point of the axis."},
    {.path = "walls.<name>.motion.rotation.speed", .type = quantity, .dimension = angular_speed, .required = true,
     .doc = "Angular speed, right-handed about the axis."},
    {.path = "walls.<name>.motion.circular", .doc = "Translation along a horizontal circle; the given shape is in the position at t = 0."},
    {.path = "walls.<name>.motion.circular.radius", .type = quantity, .dimension = length, .required = true, .range = not_negative,
     .doc = "Radius of the circle."},
    {.path = "walls.<name>.motion.circular.period", .type = quantity, .dimension = Dimension::time, .required = true, .range = positive,
     .doc = "Time of one revolution."},

    {.path = "crusher", .doc = "Geometry of the gyratory crusher, required by motion: gyration; z = 0 is the discharge plane."},
    {.path = "crusher.profile", .type = file,
     .doc = "CSV with the header z_m,mantle_radius_m,concave_radius_m: the liners as surfaces of revolution, instead of two "
            "meshes; without an entry in walls they are made of `steel`."},
    {.path = "crusher.closed_side_setting", .type = quantity, .dimension = length, .required = true, .range = positive,
     .doc = "Smallest gap at the discharge plane; the height of the mantle is adjusted to give this gap."},
    {.path = "crusher.eccentricity", .type = quantity, .dimension = length, .required = true, .range = not_negative,
     .doc = "Half the throw at the discharge plane."},
    {.path = "crusher.pivot_height", .type = quantity, .dimension = length, .required = true, .range = positive,
     .doc = "Height above the discharge plane of the point about which the mantle gyrates."},
    {.path = "crusher.removal_depth", .type = quantity, .dimension = length, .range = positive,
     .doc = "Depth below the discharge plane at which discharged fragments are removed; by default they are removed as soon as "
            "they can no longer touch anything."},
    {.path = "crusher.lid", .type = quantity, .dimension = length, .range = positive,
     .doc = "Height z of a lid: the wall `lid`, a cylinder on the rim of the concave with a plate at this height, of the concave's "
            "material. No rock leaves over the rim then; all rock must appear below the lid."},
};

const std::vector<Key> run_keys = {
    {.path = "coupling", .defaulted = true, .doc = "Exchange between rock and drivetrain."},
    {.path = "coupling.interval", .type = quantity, .dimension = Dimension::time, .fallback = "0.5 ms", .range = positive,
     .doc = "Length of a coupling window, a whole number of time steps."},
    {.path = "coupling.residual_limit", .type = quantity, .fallback = "0.02", .range = not_negative,
     .doc = "Windows are halved while the power that the exchange adds or loses is more than this share of the exchanged power; "
            "0: never."},
    {.path = "gravity", .type = vector, .dimension = acceleration, .fallback = "[0, 0, -9.81]", .doc = "Acceleration of gravity."},
    {.path = "numerics", .defaulted = true, .doc = "Numerical settings."},
    {.path = "numerics.precision", .type = word, .fallback = "mixed", .words = "mixed|double",
     .doc = "mixed: positions and velocities in double precision, laws in single precision; double: everything in double precision."},
    {.path = "numerics.hold", .type = quantity, .dimension = Dimension::time, .fallback = "auto", .range = positive, .words = "auto|off",
     .doc = "Time for which contact and wall forces are kept constant while the bonds of each rock take as many steps as they need; "
            "auto: half the undamped stability limit of contacts (0.35 of it with bonds.damping below 0.01; less in proportion with time.safety "
            "below 0.7), rounded down so that coupling.interval is a whole number of holds; a number must not exceed that share. "
            "off, and auto with numerics.substeps above 1 or without bonds: bonds and contacts take the same steps."},
    {.path = "numerics.substeps", .type = integer, .fallback = "1", .range = {.low = 1, .high = 16},
     .doc = "Above 1, in place of numerics.hold: number of bond steps, the same for all rocks, during which contact and wall forces are "
            "kept constant; this number times the time step must be less than half the undamped stability limit of contacts."},

    {.path = "numerics.fidelity", .type = word, .fallback = "reference", .words = "reference|engineering|survey",
     .doc = "What a case that does not give them itself takes for the keys that trade accuracy for speed. reference: no level of detail; "
            "engineering: numerics.levels {rigid: pieces}; survey: also rocks.fill.floor, a sixth of crusher.closed_side_setting, with "
            "rocks.fill.ratio. cases/bench/levels/README.md has the errors of each."},
    {.path = "numerics.levels", .defaulted = true,
     .doc = "Levels of detail: what is computed only while a rock needs it. Each changes results a little."},
    {.path = "numerics.levels.rigid", .type = word, .fallback = "off", .words = "off|rocks|pieces",
     .doc = "rocks: an intact rock moves as a rigid body while the contact forces on it, which are looked at every 0.1 ms, stress its bonds "
            "little; pieces: the pieces of broken rocks do so, too, and single particles take the step of contacts; off: all bonds are "
            "always evaluated. On the CPU only."},
    {.path = "numerics.levels.bonded_above", .type = quantity, .fallback = "0.5", .range = {.low = 0, .high = 1, .low_open = true}, .when = "rigid=rocks|pieces",
     .doc = "Static stress / strength of a bond, from the contact forces on a rigid rock, beyond which the rock's bonds are evaluated."},
    {.path = "numerics.levels.rigid_below", .type = quantity, .fallback = "0.2", .range = {.low = 0, .high = 1, .low_open = true}, .when = "rigid=rocks|pieces",
     .doc = "Stress / strength below which all bonds of a rock or piece must stay for calm_time before it becomes rigid, as "
            "seen at the ends of coupling intervals. With pieces, broken bonds that still press become contacts below half of it."},
    {.path = "numerics.levels.calm_time", .type = quantity, .dimension = Dimension::time, .fallback = "5 ms", .range = positive, .when = "rigid=rocks|pieces",
     .doc = "Time for which a rock or piece must be loaded little before it becomes rigid. With pieces, broken rocks are divided every half of it."},

    {.path = "particles", .doc = "Start state from files, instead of a feed or in addition to it."},
    {.path = "particles.file", .type = file, .required = true,
     .doc = "CSV with the header id,x,y,z,r[,vx,vy,vz][,wx,wy,wz][,rock], in SI units (w: angular velocity in rad/s); the density is "
            "that of materials.rock."},
    {.path = "particles.bonds", .type = file, .doc = "CSV with the header i,j[,length0]; i and j are ids of particles, length0 is the rest length in m, the distance at the start by default."},

    {.path = "laboratory",
     .doc = "Test of a rock that is pressed between two planes: strength and stiffness are written to the summary, the curve to "
            "force_displacement.csv."},
    {.path = "laboratory.test", .type = word, .required = true, .words = "platen|brazilian|uniaxial",
     .doc = "platen: any rock, with the strength 0.9 F/d^2; brazilian: a cylinder loaded across its axis, 2 F/(pi D t); uniaxial: a cylinder "
            "loaded along its axis, F/A, with a modulus."},
    {.path = "laboratory.fixed", .type = text, .required = true, .doc = "Plane against which the rock is pressed, a name from walls."},
    {.path = "laboratory.moving", .type = text, .required = true,
     .doc = "Plane with motion: linear, a name from walls; the measured force is the mean of both planes."},

    {.path = "output", .defaulted = true, .doc = "What a run writes, and how often."},
    {.path = "output.series", .type = quantity, .dimension = Dimension::time, .fallback = "1 ms", .range = positive,
     .doc = "Simulated time between rows of /series, at least coupling.interval."},
    {.path = "output.snapshots", .type = quantity, .dimension = Dimension::time, .fallback = "20 ms", .range = not_negative,
     .doc = "Simulated time between snapshots, at least coupling.interval; 0: none."},
    {.path = "output.checkpoints", .type = quantity, .dimension = Dimension::time, .fallback = "5 min", .range = not_negative,
     .doc = "Wall-clock time between checkpoints, at least 1 ms; 0: one at the end only."},
    {.path = "output.probes", .type = integers, .range = {.low = 0, .high = 4294967294.0},
     .doc = "Ids of particles whose position, velocity and angular velocity are written in each row of /series; NaN after they have "
            "left the scene."},
    {.path = "output.sieves", .type = quantities, .dimension = length, .range = positive,
     .doc = "Openings of the sieves of /product and /holdup, at least two, increasing; by default 125 mm x 2^(k/2) from 1 mm "
            "to 1 m. P80, P50 and the shares below both settings are interpolated between these sieves, and are missing outside their range."},
    {.path = "output.fines", .one_of = "breakage|gates_gaudin_schuhmann",
     .doc = "Estimate of the rock finer than the particles, which are the smallest pieces: further curves and figures in /product, /holdup and "
            "the summary; all others stay those of the particles."},
    {.path = "output.fines.breakage",
     .doc = "Fines from the energy E that broke a fragment / its mass, known from what its broken bonds released: t10 = A (1 - exp(-b E)) is the share finer than a "
            "tenth of the size that its rock was fed with, and the other t_n follow from t10."},
    {.path = "output.fines.breakage.A", .type = quantity, .required = true, .range = {.low = 0, .high = 1, .low_open = true},
     .doc = "Largest t10, from drop-weight tests of the ore: 64.5 % for a compact itabirite."},
    {.path = "output.fines.breakage.b", .type = quantity, .dimension = mass_per_energy, .required = true,
     .range = {.low = 0, .high = 0.1, .low_open = true},
     .doc = "From the same tests: 10.5 t/kWh for that ore; A b is 30 to 40 % t/kWh for very hard, 40 to 55 for medium and above 100 for soft ores."},
    {.path = "output.fines.breakage.released_share", .type = quantity, .fallback = "1", .range = {.low = 0, .high = 1, .low_open = true},
     .doc = "Energy that bonds release / energy that a drop-weight test counts, by which E is divided. With 1, t10 is a lower bound; the stiffer the "
            "bonds, the less they release: bond_breakage / wall_work of /ledger is the share of the work of the walls."},
    {.path = "output.fines.gates_gaudin_schuhmann",
     .doc = "Each single particle that has broken off a rock stands for pieces of which the mass share (x/d)^m is smaller than x, d being the size "
            "of the particle."},
    {.path = "output.fines.gates_gaudin_schuhmann.m", .type = quantity, .required = true, .range = {.low = 0, .high = 5, .low_open = true},
     .doc = "Exponent."},
    {.path = "output.formats", .type = words, .fallback = "[vtp]", .words = "vtp|hdf5",
     .doc = "Files of the snapshots: vtp writes one for each snapshot and kind of data; hdf5 writes all of them into fields.h5, for ParaView and for programs."},
    {.path = "output.liners",
     .doc = "Maps of pressure and sliding work of every wall except planes, in /liners of results.h5; without this section no maps "
            "are computed."},
    {.path = "output.liners.interval", .type = quantity, .dimension = Dimension::time, .required = true, .range = positive,
     .doc = "Simulated time between maps, at least coupling.interval; each map is the mean over this interval."},
    {.path = "output.liners.rows", .type = integer, .fallback = "32", .range = {.low = 1, .high = 1000},
     .doc = "Number of cells of the unrolled map over the height."},
    {.path = "output.liners.sectors", .type = integer, .fallback = "72", .range = {.low = 1, .high = 3600},
     .doc = "Number of cells of the unrolled map over the azimuth."},
    {.path = "output.liners.wear_coefficient", .type = quantity, .dimension = compliance, .range = positive,
     .doc = "Archard coefficient: worn volume / (normal force x sliding distance); with it the maps by triangle also contain the "
            "depth of wear."},
};
// clang-format on

std::vector<Key> all_keys() {
  std::vector<Key> all;
  for (const auto* group : {&identity_keys, &material_keys, &rock_keys, &wall_keys, &drivetrain_keys(), &run_keys})
    all.insert(all.end(), group->begin(), group->end());
  return all;
}

}  // namespace

const std::vector<Key>& schema_keys() {
  static const std::vector<Key> all = all_keys();
  return all;
}

}  // namespace gyro
