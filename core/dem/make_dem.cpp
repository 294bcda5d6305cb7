// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dem/make_dem.hpp"

#include "core/dem/solver.hpp"
#include "core/exec/cpu.hpp"
#include "core/kernels/pair_pack.hpp"
#include "core/kernels/particle_pack.hpp"
#include "core/kernels/wall_pack.hpp"
#include "core/kernels/wide_bond_pack.hpp"

namespace gyro {

std::unique_ptr<Dem> make_cpu_dem(const Scene& scene, Precision precision, int threads) {
  if (precision == Precision::mixed) return std::make_unique<DemSolver<Cpu, float>>(scene, Cpu(threads));
  return std::make_unique<DemSolver<Cpu, double>>(scene, Cpu(threads));
}

}  // namespace gyro
