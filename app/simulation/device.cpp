// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/simulation/device.hpp"

#include "core/base/errors.hpp"
#include "core/base/thread_team.hpp"

#if defined(GYRO_WITH_CUDA)
#include "gpu/make_cuda_dem.hpp"
#endif

namespace gyro {

Device choose_device(const std::string& asked, int threads) {
  Device device{false, threads > 0 ? threads : all_cores(), "cpu"};
#if defined(GYRO_WITH_CUDA)
  if (asked == "cuda" || (asked == "auto" && cuda_device_is_there())) {
    device.cuda = true;
    device.name = cuda_device_report();
  }
#else
  if (asked == "cuda")
    throw NoDevice("this gyrosim was built without CUDA; use --device cpu, or build again with GYRO_CUDA=ON");
#endif
  return device;
}

std::unique_ptr<Dem> make_dem(const Device& device, const Scene& scene, Precision precision) {
#if defined(GYRO_WITH_CUDA)
  if (device.cuda) return make_cuda_dem(scene, precision);
#endif
  return make_cpu_dem(scene, precision, device.threads);
}

}  // namespace gyro
