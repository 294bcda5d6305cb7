// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/assembly/assembly.hpp"
#include "io/run/summary.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace gyro {

/// Measurements of a test over time, and the data that its evaluation needs.
struct Compression {
  struct Break {
    double time;
    double place;  ///< between the platens: -0.5 at the fixed one, 0.5 at the moving one
  };
  CaseLaboratory::Test test = CaseLaboratory::Test::platen;
  std::vector<double> time, force;       ///< mean of both platens, so that inertia cancels [s], [N]
  double begin = 0;                      ///< time until which the moving platen has no load [s]
  std::vector<double> largest_fragment;  ///< mass [kg]
  std::vector<Break> breaks;             ///< of bonds, in the order of time
  double gap = 0;                        ///< between the platens at t = 0 [m]
  double closing_speed = 0;              ///< [m/s]
  double diameter = 0, length = 0;       ///< of a cylinder [m]
};

/// A point of the force-displacement curve, which begins at first contact.
struct CurvePoint {
  double displacement, force;  ///< [m], [N]
};

struct LaboratoryReport {
  LaboratoryFigures figures;
  std::vector<CurvePoint> curve;
};

/// A lump or a disc pressed from two sides splits: it has failed when its largest fragment has less than 2/3 of its
/// mass, and the failure force is the largest until then; the force may fall and rise again before, while corners are
/// crushed. Of a cylinder pressed along its axis it is the largest of all, if the force has fallen by 30 % from there
/// after a bond broke. Breaks count from the moment when the moving platen first has a load, because a rock that falls
/// onto the fixed one may lose bonds before. Contact is where the force last rises above 0.5 % of the failure force
/// before the first of them. Strengths: platen 0.9 F/d^2, d the distance of the platens at contact (Hiramatsu & Oka,
/// Int. J. Rock Mech. Min. Sci. 3 (1966) 89); brazilian 2 F/(pi D t) (ISRM suggested method, Int. J. Rock Mech. Min.
/// Sci. 15 (1978) 99) without a correction for flats; uniaxial F/A.
LaboratoryReport evaluate(Compression compression);

/// Reads the measurements of a run from a closed results.h5.
Compression measured_compression(const Case& input, const Assembly& assembly, const std::filesystem::path& results);

/// Evaluates a finished run and writes force_displacement.csv beside its results. @throws OutputError
LaboratoryFigures write_laboratory(const Case& input, const Assembly& assembly, const std::filesystem::path& directory);

}  // namespace gyro
