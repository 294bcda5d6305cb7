// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dem/solver.hpp"
#include "gpu/cuda.cuh"
#include "gpu/make_cuda_dem.hpp"

namespace gyro {

std::unique_ptr<Dem> make_cuda_dem(const Scene& scene, Precision precision) {
  Cuda device;
  cudaFuncAttributes loaded;  // asks the driver for the code before any memory is taken
  check_cuda(cudaFuncGetAttributes(&loaded, run_each<CellBegins>), "loading the kernels");
  if (precision == Precision::mixed) return std::make_unique<DemSolver<Cuda, float>>(scene, std::move(device));
  return std::make_unique<DemSolver<Cuda, double>>(scene, std::move(device));
}

}  // namespace gyro
