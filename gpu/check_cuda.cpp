// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/check_cuda.hpp"

#include "core/base/errors.hpp"

#include <cstdlib>
#include <string>

namespace gyro {

void check_cuda(cudaError_t status, const char* doing) {
  if (status == cudaSuccess) return;
  cudaGetLastError();  // an error that can be recovered from is not reported twice
  const std::string message = std::string("CUDA, ") + doing + ": " + cudaGetErrorString(status);
  switch (status) {
    case cudaErrorMemoryAllocation:
      throw NoDevice(message + "; the scene needs a device with more memory, or --device cpu");
    case cudaErrorNoDevice:
    case cudaErrorInsufficientDriver:
    case cudaErrorInitializationError:
    case cudaErrorDevicesUnavailable:
    case cudaErrorNoKernelImageForDevice:
    case cudaErrorUnsupportedPtxVersion:
      throw NoDevice(message + "; use a CUDA device and driver that this program was built for, or --device cpu");
    default:
      throw std::runtime_error(message);
  }
}

bool waits_for_all() {
  const char* value = std::getenv("GYRO_CUDA_SYNC");
  return value != nullptr && std::string(value) == "1";
}

}  // namespace gyro
