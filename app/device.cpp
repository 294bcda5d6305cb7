// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/device.hpp"

#include "core/base/errors.hpp"

#include <algorithm>
#include <thread>

#if defined(GYRO_WITH_CUDA)
#include "gpu/make_cuda_dem.hpp"
#endif

namespace gyro {

Device choose_device(const std::string& asked, int threads) {
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  Device device{false, threads > 0 ? threads : cores, "cpu"};
  if (asked != "cuda") return device;
#if defined(GYRO_WITH_CUDA)
  device.cuda = true;
  device.name = cuda_device_report();
  return device;
#else
  throw NoDevice("this gyrosim was built without CUDA; --device cpu is accepted");
#endif
}

std::unique_ptr<Dem> make_dem(const Device& device, const Scene& scene, Loads loads) {
#if defined(GYRO_WITH_CUDA)
  if (device.cuda) return make_cuda_dem(scene, loads);
#endif
  return make_cpu_dem(scene, loads, device.threads);
}

}  // namespace gyro
