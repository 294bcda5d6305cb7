// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/schema.hpp"

namespace gyro {
namespace {

using enum KeyType;
using enum Dimension;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr Range positive{.low = 0, .low_open = true};
constexpr Range not_negative{.low = 0};

// The formatter would put every field on its own line.
// clang-format off
const std::vector<Key> identity_keys = {
    {.path = "case", .defaulted = true, .doc = "What the run is called, and the key of its random numbers."},
    {.path = "case.title", .type = text, .doc = "Free text for logs and reports; without it the file's name."},
    {.path = "case.seed", .type = integer, .fallback = "1", .range = {.low = 0, .high = 9007199254740992.0},
     .doc = "Key of all random numbers: shapes, fills, sizes, places, strengths."},

    {.path = "time", .required = true, .doc = "How long, and in which steps."},
    {.path = "time.duration", .type = quantity, .dimension = Dimension::time, .required = true, .range = positive,
     .doc = "Simulated time."},
    {.path = "time.step", .type = quantity, .dimension = Dimension::time, .fallback = "auto", .range = positive, .words = "auto",
     .doc = "Time step. auto: safety x damped stability limit, rounded down so that it divides the coupling interval; "
            "a number must not lie above safety x limit."},
    {.path = "time.safety", .type = quantity, .fallback = "0.7", .range = {.low = 0, .high = 1, .low_open = true},
     .doc = "Largest step / damped stability limit. Nearer to 1 the bonds of breaking rock begin to explode."},
};

const std::vector<Key> material_keys = {
    {.path = "materials", .type = named, .required = true,
     .doc = "Elastic solids by name. `rock` is what all particles are made of and must be there."},
    {.path = "materials.<name>.density", .type = quantity, .dimension = density, .required = true, .range = positive,
     .doc = "Density of the solid."},
    {.path = "materials.<name>.shear_modulus", .type = quantity, .dimension = pressure, .required = true, .range = positive,
     .doc = "Shear modulus G for contacts; Young's modulus is 2 G (1 + poisson_ratio)."},
    {.path = "materials.<name>.poisson_ratio", .type = quantity, .required = true, .range = {.low = 0, .high = 0.5, .high_open = true},
     .doc = "Poisson's ratio."},

    {.path = "contacts", .type = named,
     .doc = "Surface properties of pairs of materials, `rock/steel`. Needed for every pair that can touch."},
    {.path = "contacts.<pair>.friction", .type = quantity, .required = true, .range = not_negative,
     .doc = "Coulomb coefficient."},
    {.path = "contacts.<pair>.restitution", .type = quantity, .required = true, .range = {.low = 0, .high = 1, .low_open = true},
     .doc = "Coefficient of restitution of a normal impact of two particles."},
    {.path = "contacts.<pair>.rolling_friction", .type = quantity, .fallback = "0", .range = not_negative,
     .doc = "Rolling torque / (effective radius x normal force)."},

    {.path = "bonds", .one_of = "normal_stiffness+shear_stiffness|modulus+stiffness_ratio",
     .doc = "Bonds between the particles of a rock. Leave out for unbreakable spheres."},
    {.path = "bonds.gap", .type = quantity, .fallback = "0.05", .range = {.low = 0, .high = 1, .high_open = true},
     .doc = "Neighbours whose surfaces are closer than this, times the smaller radius, are bonded."},
    {.path = "bonds.normal_stiffness", .type = quantity, .dimension = stiffness_per_area, .range = positive,
     .doc = "Normal stiffness per area of bond."},
    {.path = "bonds.shear_stiffness", .type = quantity, .dimension = stiffness_per_area, .range = positive,
     .doc = "Shear stiffness per area of bond."},
    {.path = "bonds.modulus", .type = quantity, .dimension = pressure, .range = positive,
     .doc = "Instead of the stiffnesses: modulus of the bond; normal stiffness = modulus / bond length."},
    {.path = "bonds.stiffness_ratio", .type = quantity, .range = positive,
     .doc = "With modulus: normal stiffness / shear stiffness."},
    {.path = "bonds.tensile_strength", .type = quantity, .dimension = pressure, .required = true, .range = positive,
     .doc = "Largest tension with bending at which a bond of factor 1 holds."},
    {.path = "bonds.shear_strength", .type = quantity, .dimension = pressure, .required = true, .range = positive,
     .doc = "Largest shear with torsion at which a bond of factor 1 holds."},
    {.path = "bonds.radius", .required = true, .one_of = "relative|absolute|area", .doc = "Radius of a bond's section."},
    {.path = "bonds.radius.relative", .type = quantity, .range = {.low = 0, .high = 2, .low_open = true},
     .doc = "Bond radius / smaller particle radius."},
    {.path = "bonds.radius.absolute", .type = quantity, .dimension = length, .range = positive, .doc = "The same radius for every bond."},
    {.path = "bonds.radius.area", .type = quantity, .range = {.low = 0, .high = 4, .low_open = true},
     .doc = "Section of a bond / (pi R^2), R = 2 Ri Rj/(Ri + Rj): proportional to the area in which the two particles touch."},
    {.path = "bonds.strength_scatter", .doc = "Random factor on both strengths, drawn once a bond. Without it every factor is 1."},
    {.path = "bonds.strength_scatter.distribution", .type = word, .required = true, .words = "truncated_normal|paper_literal|weibull",
     .doc = "truncated_normal: cut at the range; paper_literal: 1 + a standard normal number, drawn anew outside the range; "
            "weibull: unbounded, with a modulus."},
    {.path = "bonds.strength_scatter.mean", .type = quantity, .fallback = "1", .range = positive,
     .when = "distribution=truncated_normal|weibull", .doc = "Mean of the distribution, of the normal one before it is cut."},
    {.path = "bonds.strength_scatter.deviation", .type = quantity, .range = not_negative,
     .when = "distribution=truncated_normal", .doc = "Standard deviation before it is cut."},
    {.path = "bonds.strength_scatter.range", .type = interval, .range = not_negative,
     .when = "distribution=truncated_normal|paper_literal", .doc = "Smallest and largest factor; the mean lies between."},
    {.path = "bonds.strength_scatter.modulus", .type = quantity, .range = positive, .when = "distribution=weibull",
     .doc = "Weibull modulus; 3 to 8 for rock, less means more scatter."},
    {.path = "bonds.damping", .type = quantity, .fallback = "0.05", .range = {.low = 0, .high = 1},
     .doc = "Damping of each mode of a bond as a share of critical."},
};

const std::vector<Key> rock_keys = {
    {.path = "rocks", .doc = "The library of rocks (meta-particles) that the feed draws from."},
    {.path = "rocks.shapes", .required = true, .one_of = "procedural|files|cylinder", .doc = "Shapes of the rocks."},
    {.path = "rocks.shapes.procedural", .type = integer, .range = {.low = 1, .high = 10000},
     .doc = "Number of random polyhedra made from the seed."},
    {.path = "rocks.shapes.files", .type = files, .doc = "Closed STL or OBJ meshes; their size is scaled to the size law."},
    {.path = "rocks.shapes.cylinder", .type = quantity, .range = {.low = 0.1, .high = 10},
     .doc = "Cylinders of this length / diameter, specimens of a laboratory; the axis is x, or z if shorter than 0.87 diameters."},
    {.path = "rocks.shapes.elongation", .type = interval, .range = {.low = 0, .high = 1, .low_open = true},
     .doc = "With procedural: intermediate / long axis of a rock, uniform between the two; without it [0.65, 0.95]."},
    {.path = "rocks.shapes.flatness", .type = interval, .range = {.low = 0, .high = 1, .low_open = true},
     .doc = "With procedural: short / intermediate axis, uniform between the two; without it [0.65, 0.95]."},
    {.path = "rocks.shapes.angularity", .type = quantity, .range = {.low = 0, .high = 1},
     .doc = "With procedural: 0 rounded, 0.5 crushed aggregate (also without the key), 1 sharp."},
    {.path = "rocks.shapes.roughness", .type = quantity, .range = {.low = 0, .high = 0.3},
     .doc = "With procedural: deviation of the surface from the polyhedron / radius; without it 0, flat faces."},
    {.path = "rocks.shapes.corners", .type = integer, .range = {.low = 8, .high = 10000},
     .doc = "With files: take the convex polyhedron of at most so many corners around each scan, not the scan itself."},
    {.path = "rocks.sizes", .required = true, .one_of = "passing|rosin_rammler|gates_gaudin_schuhmann|vendor|sieves",
     .doc = "Size distribution of the feed by mass; a rock's size is its equal-volume diameter."},
    {.path = "rocks.sizes.passing", .type = passing, .dimension = length,
     .doc = "Pairs [size, share smaller]: sizes rise, shares run from 0 to 1, linear between."},
    {.path = "rocks.sizes.rosin_rammler", .doc = "1 - exp(-(x/x63)^m), cut to min and max."},
    {.path = "rocks.sizes.rosin_rammler.x63", .type = quantity, .dimension = length, .required = true, .range = positive,
     .doc = "Size that 63.2 % pass."},
    {.path = "rocks.sizes.rosin_rammler.m", .type = quantity, .required = true, .range = positive, .doc = "Exponent."},
    {.path = "rocks.sizes.rosin_rammler.min", .type = quantity, .dimension = length, .required = true, .range = positive,
     .doc = "Smallest rock."},
    {.path = "rocks.sizes.rosin_rammler.max", .type = quantity, .dimension = length, .required = true, .range = positive,
     .doc = "Largest rock."},
    {.path = "rocks.sizes.gates_gaudin_schuhmann", .doc = "(x/xmax)^m, cut to min."},
    {.path = "rocks.sizes.gates_gaudin_schuhmann.xmax", .type = quantity, .dimension = length, .required = true, .range = positive,
     .doc = "Largest rock."},
    {.path = "rocks.sizes.gates_gaudin_schuhmann.m", .type = quantity, .required = true, .range = positive, .doc = "Exponent."},
    {.path = "rocks.sizes.gates_gaudin_schuhmann.min", .type = quantity, .dimension = length, .required = true, .range = positive,
     .doc = "Smallest rock."},
    {.path = "rocks.sizes.vendor",
     .doc = "The feed that brochures state capacities for: all of it passes 0.8, 80 % pass 0.6 and half passes 0.1 of the feed opening."},
    {.path = "rocks.sizes.vendor.feed_opening", .type = quantity, .dimension = length, .required = true, .range = positive,
     .doc = "Feed opening of the crusher."},
    {.path = "rocks.sizes.vendor.min", .type = quantity, .dimension = length, .required = true, .range = positive,
     .doc = "Smallest rock; below 0.1 of the opening."},
    {.path = "rocks.sizes.sieves", .type = file, .doc = "CSV with the header size_mm,passing_percent."},
    {.path = "rocks.samples", .type = integer, .fallback = "24", .range = {.low = 1, .high = 100000},
     .doc = "Rocks in the library, each a shape at a size."},
    {.path = "rocks.fill", .required = true, .one_of = "ratio|sizes", .doc = "Particles that a rock is filled with."},
    {.path = "rocks.fill.ratio", .type = quantity, .range = {.low = 2, .high = 50},
     .doc = "Equal-volume diameter of the rock / particle diameter: all particles of a rock are of one size."},
    {.path = "rocks.fill.sizes", .type = interval, .dimension = length, .range = positive,
     .doc = "Smallest and largest particle diameter, the same for all rocks; no particle is larger than a third of its rock."},
    {.path = "rocks.fill.exponent", .type = quantity, .range = {.low = 0, .high = 5, .low_open = true},
     .doc = "With sizes: the volume share of particles finer than x grows as x^exponent. Without it 0.8, "
            "which puts 20,000 particles of 8 to 45 mm into a rock of 500 mm."},
    {.path = "rocks.density", .type = word, .fallback = "compensated", .words = "compensated|material",
     .doc = "compensated: a rock weighs what solid rock of its shape weighs, its particles are denser; "
            "material: particles have the density of materials.rock."},

    {.path = "feed", .doc = "Rocks that enter. A continuous feed (initial, rate), a batch (mass), or rocks at a place (rocks, at)."},
    {.path = "feed.initial", .type = quantity, .dimension = mass, .range = not_negative, .doc = "Mass in the chamber at t = 0."},
    {.path = "feed.initial_top", .type = quantity, .dimension = length, .doc = "The initial charge lies below this height z."},
    {.path = "feed.rate", .type = quantity, .dimension = mass_flow, .range = not_negative, .doc = "Mass flow of the feed."},
    {.path = "feed.start", .type = quantity, .dimension = Dimension::time, .fallback = "0 s", .range = not_negative,
     .doc = "When the rate sets in, or the batch is dropped."},
    {.path = "feed.mass", .type = quantity, .dimension = mass, .range = positive, .doc = "A batch of this mass, and nothing else."},
    {.path = "feed.above", .type = text,
     .doc = "Wall (a mesh or a liner) above whose opening rocks appear; without it `concave` where there is one."},
    {.path = "feed.rocks", .type = integer, .range = {.low = 1, .high = 1000000},
     .doc = "Number of rocks that are there at t = 0, taken from the library in turn; needs at."},
    {.path = "feed.at", .type = vector, .dimension = length,
     .doc = "Centre of mass of the first of these rocks; the others are stacked above it."},
};

const std::vector<Key> wall_keys = {
    {.path = "walls", .type = named, .doc = "Rigid walls by name; `concave` and `mantle` take their shape from crusher.profile if that is given."},
    {.path = "walls.<name>.stl", .type = file, .doc = "Closed or open STL or OBJ mesh in metres."},
    {.path = "walls.<name>.plane", .doc = "Infinite plane; rock is on the side of the normal."},
    {.path = "walls.<name>.plane.point", .type = vector, .dimension = length, .required = true, .doc = "A point of the plane."},
    {.path = "walls.<name>.plane.normal", .type = vector, .required = true, .doc = "Its normal, of any length but 0."},
    {.path = "walls.<name>.material", .type = text, .required = true, .doc = "A name of materials."},
    {.path = "walls.<name>.motion", .words = "fixed|gyration", .one_of = "linear|rotation|circular",
     .doc = "How it moves; without it fixed, but gyration for a mantle from crusher.profile."},
    {.path = "walls.<name>.motion.linear", .type = vector, .dimension = speed, .doc = "Velocity."},
    {.path = "walls.<name>.motion.rotation", .doc = "Turns about a fixed axis."},
    {.path = "walls.<name>.motion.rotation.axis", .type = vector, .required = true, .doc = "Direction, of any length but 0."},
    {.path = "walls.<name>.motion.rotation.point", .type = vector, .dimension = length, .required = true, .doc = "A point of the axis."},
    {.path = "walls.<name>.motion.rotation.speed", .type = quantity, .dimension = angular_speed, .required = true,
     .doc = "Right-handed about the axis."},
    {.path = "walls.<name>.motion.circular", .doc = "Translation on a horizontal circle, starting where it is drawn."},
    {.path = "walls.<name>.motion.circular.radius", .type = quantity, .dimension = length, .required = true, .range = not_negative,
     .doc = "Radius of the circle."},
    {.path = "walls.<name>.motion.circular.period", .type = quantity, .dimension = Dimension::time, .required = true, .range = positive,
     .doc = "Time of one round."},

    {.path = "crusher", .doc = "Geometry of the gyratory crusher; needed by motion: gyration. z = 0 is the discharge plane."},
    {.path = "crusher.profile", .type = file,
     .doc = "CSV with the header z_m,mantle_radius_m,concave_radius_m: the liners as surfaces of revolution, instead of two meshes. "
            "Without an entry in walls they are made of `steel`."},
    {.path = "crusher.closed_side_setting", .type = quantity, .dimension = length, .required = true, .range = positive,
     .doc = "Smallest gap at the discharge plane, imposed by the height of the mantle."},
    {.path = "crusher.eccentricity", .type = quantity, .dimension = length, .required = true, .range = not_negative,
     .doc = "Half the throw, at the discharge plane."},
    {.path = "crusher.pivot_height", .type = quantity, .dimension = length, .required = true, .range = positive,
     .doc = "Height of the point about which the mantle gyrates, above the discharge plane."},
    {.path = "crusher.removal_depth", .type = quantity, .dimension = length, .range = positive,
     .doc = "Discharged fragments are removed this far below the discharge plane; without it as soon as they can touch nothing."},
};

const std::vector<Key> drive_keys = {
    {.path = "drivetrain", .doc = "Motor, gear and inertia that turn the eccentric. Without it the case has no gyration."},
    {.path = "drivetrain.motor", .required = true, .doc = "Torque of the motor against its speed."},
    {.path = "drivetrain.motor.model", .type = word, .required = true, .words = "induction|double_cage|nema|droop|curve|constant_speed",
     .doc = "induction: after Kloss; double_cage: with the starting torque of its name plate; nema: a typical motor of a design letter; "
            "droop: a straight line; curve: a table; constant_speed: ideal drive."},
    {.path = "drivetrain.motor.rated_power", .type = quantity, .dimension = power, .range = positive, .when = "model=induction|double_cage|nema",
     .doc = "Mechanical power at rated slip."},
    {.path = "drivetrain.motor.synchronous_speed", .type = quantity, .dimension = angular_speed, .range = positive,
     .when = "model=induction|double_cage|nema|droop", .doc = "Speed of zero torque."},
    {.path = "drivetrain.motor.design", .type = word, .words = "A|B|C|D", .when = "model=nema",
     .doc = "NEMA design letter. C is usual for crushers that start under load; D is for flywheel loads."},
    {.path = "drivetrain.motor.rated_slip", .type = quantity, .range = {.low = 0, .high = 1, .low_open = true, .high_open = true},
     .when = "model=induction|double_cage", .doc = "1 - rated speed / synchronous speed."},
    {.path = "drivetrain.motor.breakdown_ratio", .type = quantity, .range = {.low = 1, .high = infinite, .low_open = true},
     .when = "model=induction|double_cage", .doc = "Pull-out torque / rated torque."},
    {.path = "drivetrain.motor.starting_ratio", .type = quantity, .range = positive, .when = "model=double_cage",
     .doc = "Torque at standstill / rated torque."},
    {.path = "drivetrain.motor.stall_torque", .type = quantity, .dimension = torque, .range = positive, .when = "model=droop",
     .doc = "Torque at standstill."},
    {.path = "drivetrain.motor.file", .type = file, .when = "model=curve", .doc = "CSV with the header speed_rpm,torque_Nm."},
    {.path = "drivetrain.motor.speed", .type = quantity, .dimension = angular_speed, .range = positive, .when = "model=constant_speed",
     .doc = "Speed of the motor."},
    {.path = "drivetrain.motor.voltage", .type = quantity, .range = positive,
     .doc = "Supply / rated voltage, 1 if left out. Torque goes with its square; a droop line is shifted instead. Not with constant_speed."},
    {.path = "drivetrain.motor.voltage_file", .type = file,
     .doc = "Instead: CSV with the header time_s,voltage_ratio, straight between the rows, as of a soft starter."},
    {.path = "drivetrain.gear_ratio", .type = quantity, .required = true, .range = positive, .doc = "Motor speed / eccentric speed."},
    {.path = "drivetrain.gear_efficiency", .type = quantity, .fallback = "1", .range = {.low = 0, .high = 1, .low_open = true},
     .doc = "Share of the power that passes the gear."},
    {.path = "drivetrain.inertia", .defaulted = true, .doc = "Moments of inertia; not both 0 unless the speed is constant."},
    {.path = "drivetrain.inertia.motor", .type = quantity, .dimension = inertia, .fallback = "0", .range = not_negative,
     .doc = "Of motor, coupling and pinion, about the motor's shaft."},
    {.path = "drivetrain.inertia.eccentric", .type = quantity, .dimension = inertia, .fallback = "0", .range = not_negative,
     .doc = "Of the eccentric and its gear, about the machine's axis."},
    {.path = "drivetrain.losses", .defaulted = true, .doc = "Losses between motor and rock, as torques at the eccentric."},
    {.path = "drivetrain.losses.no_load", .type = quantity, .dimension = power, .fallback = "0", .range = not_negative,
     .doc = "Power of the idle crusher at rated speed; acts as a constant torque."},
    {.path = "drivetrain.losses.load_factor", .type = quantity, .fallback = "0", .range = not_negative,
     .doc = "Share of the rock's torque that bushings lose; leave it at 0 where drivetrain.bearings says it from the forces."},
    {.path = "drivetrain.losses.viscous", .type = quantity, .dimension = rotational_damping, .fallback = "0", .range = not_negative,
     .doc = "Torque / speed of the eccentric."},
    {.path = "drivetrain.start", .type = word, .fallback = "running", .words = "running|rest",
     .doc = "running: at t = 0 the motor just carries the losses; rest: it is switched on at t = 0."},
};

const std::vector<Key> machine_keys = {
    {.path = "drivetrain.coupling_spring", .doc = "Compliance between motor and pinion. Without it the shaft is rigid."},
    {.path = "drivetrain.coupling_spring.stiffness", .type = quantity, .dimension = torque, .required = true, .range = positive,
     .doc = "Torque / twist, at the motor's shaft (N m per rad)."},
    {.path = "drivetrain.coupling_spring.damping", .type = quantity, .dimension = rotational_damping, .fallback = "0", .range = not_negative,
     .doc = "Torque / speed of twist."},

    {.path = "drivetrain.mantle_inertia", .type = quantity, .dimension = inertia, .range = positive,
     .doc = "Of the mantle with its shaft, about its own axis. With it the mantle spins freely between bushing, spider and rock; without, not at all."},
    {.path = "drivetrain.bearings", .doc = "Dry friction of the bearings that carry the crushing force: friction x radius x (idle_force + force of the rock)."},
    {.path = "drivetrain.bearings.bushing_depth", .type = quantity, .dimension = length, .required = true, .range = positive,
     .doc = "Height from the eccentric's bushings up to the pivot."},
    {.path = "drivetrain.bearings.outer", .doc = "Eccentric in the frame: brakes the eccentric."},
    {.path = "drivetrain.bearings.outer.friction", .type = quantity, .required = true, .range = not_negative, .doc = "Coefficient; oil-fed bronze 0.003 to 0.01."},
    {.path = "drivetrain.bearings.outer.radius", .type = quantity, .dimension = length, .required = true, .range = positive, .doc = "Of the sliding surface."},
    {.path = "drivetrain.bearings.outer.idle_force", .type = quantity, .dimension = force, .fallback = "0", .range = not_negative,
     .doc = "Force without rock, from weight and unbalance."},
    {.path = "drivetrain.bearings.inner", .doc = "Mantle's shaft in the eccentric: drags the mantle along with the eccentric."},
    {.path = "drivetrain.bearings.inner.friction", .type = quantity, .required = true, .range = not_negative, .doc = "Coefficient."},
    {.path = "drivetrain.bearings.inner.radius", .type = quantity, .dimension = length, .required = true, .range = positive, .doc = "Of the sliding surface."},
    {.path = "drivetrain.bearings.inner.idle_force", .type = quantity, .dimension = force, .fallback = "0", .range = not_negative,
     .doc = "Force without rock, from weight and unbalance."},
    {.path = "drivetrain.bearings.spider", .doc = "Mantle's shaft in the spider, at the pivot: holds the mantle back."},
    {.path = "drivetrain.bearings.spider.friction", .type = quantity, .required = true, .range = not_negative, .doc = "Coefficient."},
    {.path = "drivetrain.bearings.spider.radius", .type = quantity, .dimension = length, .required = true, .range = positive, .doc = "Of the sliding surface."},
    {.path = "drivetrain.bearings.spider.idle_force", .type = quantity, .dimension = force, .fallback = "0", .range = not_negative,
     .doc = "Force without rock, from weight and unbalance."},

    {.path = "drivetrain.protection", .doc = "Relays that switch the motor off, and what comes after. Currents are relative to the rated one."},
    {.path = "drivetrain.protection.overload_time", .type = quantity, .dimension = Dimension::time, .range = positive,
     .doc = "Inverse-time relay: time constant of the thermal image, which trips at overload_ratio^2 (IEC 60255-149)."},
    {.path = "drivetrain.protection.overload_ratio", .type = quantity, .fallback = "1.05", .range = positive,
     .doc = "Current that the thermal image carries for ever."},
    {.path = "drivetrain.protection.instantaneous_ratio", .type = quantity, .range = positive, .doc = "Current that trips at once; above that of the start."},
    {.path = "drivetrain.protection.under_speed", .type = quantity, .range = {.low = 0, .high = 1, .low_open = true, .high_open = true},
     .doc = "Share of the idle speed; slower than this for under_speed_delay trips, once it has been faster."},
    {.path = "drivetrain.protection.under_speed_delay", .type = quantity, .dimension = Dimension::time, .fallback = "0", .range = not_negative,
     .doc = "Time below under_speed before it trips."},
    {.path = "drivetrain.protection.rated_torque", .type = quantity, .dimension = torque, .range = positive,
     .doc = "Of the motor: its current is |torque| / rated_torque. For droop and curve, where a relay looks at the current."},
    {.path = "drivetrain.protection.brake_torque", .type = quantity, .dimension = torque, .fallback = "0", .range = not_negative,
     .doc = "Dry brake at the motor's shaft from a trip to the restart; 0: the machine coasts."},
    {.path = "drivetrain.protection.restart_delay", .type = quantity, .dimension = Dimension::time, .range = positive,
     .doc = "From a trip to the restart; without it the motor stays off."},
    {.path = "drivetrain.protection.restarts", .type = integer, .fallback = "1", .range = {.low = 0, .high = 1000}, .doc = "Restarts at most."},
    {.path = "drivetrain.protection.restart_sense", .type = word, .fallback = "same", .words = "same|reversed",
     .doc = "reversed: each restart changes the sense of rotation, to clear the chamber."},
};

const std::vector<Key> run_keys = {
    {.path = "coupling", .defaulted = true, .doc = "Exchange between rock and drivetrain."},
    {.path = "coupling.interval", .type = quantity, .dimension = Dimension::time, .fallback = "0.5 ms", .range = positive,
     .doc = "Length of a window; the time step divides it."},
    {.path = "coupling.residual_limit", .type = quantity, .fallback = "0.02", .range = not_negative,
     .doc = "Windows are halved while the power that the exchange makes up or loses is more than this share of what it passes; 0: never."},
    {.path = "gravity", .type = vector, .dimension = acceleration, .fallback = "[0, 0, -9.81]", .doc = "Acceleration of gravity."},
    {.path = "numerics", .defaulted = true, .doc = "How it is computed."},
    {.path = "numerics.precision", .type = word, .fallback = "mixed", .words = "mixed|double",
     .doc = "mixed: positions and velocities double, laws single; double: all double."},
    {.path = "numerics.substeps", .type = integer, .fallback = "1", .range = {.low = 1, .high = 16},
     .doc = "Time steps of the bonds over which contact and wall forces are held; their product with the step stays below half the limit of contacts."},

    {.path = "particles", .doc = "A start state from files, instead of or beside a feed."},
    {.path = "particles.file", .type = file, .required = true,
     .doc = "CSV with the header id,x,y,z,r[,vx,vy,vz][,rock], SI; their density is that of materials.rock."},
    {.path = "particles.bonds", .type = file, .doc = "CSV with the header i,j[,length0]; i and j are ids."},

    {.path = "output", .defaulted = true, .doc = "What is written, and how often."},
    {.path = "output.series", .type = quantity, .dimension = Dimension::time, .fallback = "1 ms", .range = positive,
     .doc = "Simulated time between rows of /series."},
    {.path = "output.snapshots", .type = quantity, .dimension = Dimension::time, .fallback = "20 ms", .range = not_negative,
     .doc = "Simulated time between snapshots; 0: none."},
    {.path = "output.checkpoints", .type = quantity, .dimension = Dimension::time, .fallback = "5 min", .range = not_negative,
     .doc = "Wall-clock time between checkpoints; 0: one at the end only."},
    {.path = "output.formats", .type = words, .fallback = "[vtp]", .words = "vtp|hdf5",
     .doc = "Files of a snapshot: vtp for ParaView; hdf5 adds fields.h5 with an XDMF index."},
    {.path = "output.liners", .doc = "Maps of pressure and sliding work of every wall but planes, in /liners of results.h5. Without it they cost nothing."},
    {.path = "output.liners.interval", .type = quantity, .dimension = Dimension::time, .required = true, .range = positive,
     .doc = "Simulated time between maps; each is the mean over it."},
    {.path = "output.liners.rows", .type = integer, .fallback = "32", .range = {.low = 1, .high = 1000}, .doc = "Cells of the unrolled map by height."},
    {.path = "output.liners.sectors", .type = integer, .fallback = "72", .range = {.low = 1, .high = 3600}, .doc = "Cells of the unrolled map by azimuth."},
    {.path = "output.liners.wear_coefficient", .type = quantity, .range = positive,
     .doc = "Archard: volume worn / (normal force x sliding way), 1/Pa. Adds the depth worn to the maps by triangle."},
};
// clang-format on

std::vector<Key> all_keys() {
  std::vector<Key> all;
  for (const auto* group :
       {&identity_keys, &material_keys, &rock_keys, &wall_keys, &drive_keys, &machine_keys, &run_keys})
    all.insert(all.end(), group->begin(), group->end());
  return all;
}

}  // namespace

const std::vector<Key>& schema_keys() {
  static const std::vector<Key> all = all_keys();
  return all;
}

}  // namespace gyro
