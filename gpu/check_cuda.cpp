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

namespace {

bool is_set(const char* variable, const char* to) {
  const char* value = std::getenv(variable);
  return value != nullptr && std::string(value) == to;
}

}  // namespace

bool waits_for_all() {
  return is_set("GYRO_CUDA_SYNC", "1");
}

bool without_graphs() {
  return is_set("GYRO_CUDA_GRAPHS", "0");
}

int max_steps_ahead() {
  constexpr int no_limit = 1'000'000;
  const char* value = std::getenv("GYRO_CUDA_AHEAD");
  if (value == nullptr) return no_limit;
  char* end = nullptr;
  const long steps = std::strtol(value, &end, 10);
  if (end == value || *end != '\0' || steps < 1 || steps > no_limit)
    throw BadInput("GYRO_CUDA_AHEAD is '" + std::string(value) + "'; it must be a number of steps, 1 to 1000000");
  return static_cast<int>(steps);
}

}  // namespace gyro
