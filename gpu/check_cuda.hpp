// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cuda_runtime_api.h>

namespace gyro {

/// Passes cudaSuccess, throws for all else.
/// @param doing  what was under way, as in "launching pair forces"
/// @throws NoDevice when there is no usable device or its memory ran out, std::runtime_error otherwise
void check_cuda(cudaError_t status, const char* doing);

/// Makes the first device the one in use.
/// @throws NoDevice with the driver's reason when there is none that this program was compiled for
void take_device();

/// Whether GYRO_CUDA_SYNC=1 asks to wait for every kernel: slower, errors and times then belong to
/// the kernel that they are reported for.
bool waits_for_all();

/// Whether GYRO_CUDA_GRAPHS=0 asks to launch every kernel of a step by itself.
bool without_graphs();

/// GYRO_CUDA_AHEAD: how many steps at most are launched before the host waits for them; 1: it waits for each.
int max_steps_ahead();

}  // namespace gyro
