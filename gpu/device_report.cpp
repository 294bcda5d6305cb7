// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/errors.hpp"
#include "gpu/check_cuda.hpp"
#include "gpu/make_cuda_dem.hpp"

#include <cuda_runtime_api.h>

namespace gyro {

void take_device() {
  int count = 0;
  check_cuda(cudaGetDeviceCount(&count), "looking for a device");
  check_cuda(count > 0 ? cudaSuccess : cudaErrorNoDevice, "looking for a device");
  check_cuda(cudaSetDevice(0), "taking the first device");
}

namespace {

/// CUDA's numbers as people write them: 13000 is 13.0.
std::string version_text(int version) {
  return version == 0 ? "none" : std::to_string(version / 1000) + "." + std::to_string(version % 1000 / 10);
}

}  // namespace

bool cuda_device_is_there() {
  int count = 0;
  const bool there = cudaGetDeviceCount(&count) == cudaSuccess && count > 0;
  cudaGetLastError();
  return there;
}

std::string cuda_device_report() {
  int driver = 0, runtime = 0, count = 0;
  cudaDriverGetVersion(&driver);
  cudaRuntimeGetVersion(&runtime);
  std::string text = "CUDA runtime " + version_text(runtime) + ", driver for CUDA " + version_text(driver);
  const cudaError_t status = cudaGetDeviceCount(&count);
  if (status != cudaSuccess || count == 0) {
    cudaGetLastError();
    return text + ", no device (" + cudaGetErrorString(status) + ")";
  }
  for (int k = 0; k < count; ++k) {
    cudaDeviceProp p;
    if (cudaGetDeviceProperties(&p, k) != cudaSuccess) continue;
    text += ", device " + std::to_string(k) + ": " + p.name + " (sm_" + std::to_string(10 * p.major + p.minor) + ", " +
            std::to_string(p.totalGlobalMem >> 20) + " MiB)";
  }
  return text;
}

}  // namespace gyro
