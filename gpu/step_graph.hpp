// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/check_cuda.hpp"
#include "gpu/traffic.hpp"

#include <utility>

namespace gyro {

/// The stream of an executor. Copies and clearing of memory run on the default stream, which waits for this one and is
/// waited for: all work on the device keeps the order in which the host asked for it.
class Stream {
 public:
  Stream() { check_cuda(cudaStreamCreate(&stream_), "making a stream"); }
  Stream(Stream&& other) noexcept : stream_(std::exchange(other.stream_, nullptr)) {}
  Stream& operator=(Stream&&) = delete;
  ~Stream() {
    if (stream_ != nullptr) cudaStreamDestroy(stream_);
  }

  cudaStream_t get() const { return stream_; }

 private:
  cudaStream_t stream_ = nullptr;
};

/// The kernels of a step, which the host starts with one call. Later records of the same kernels change the arguments
/// of the graph that is there.
class StepGraph {
 public:
  StepGraph() = default;
  StepGraph(StepGraph&& other) noexcept : graph_(std::exchange(other.graph_, nullptr)) {}
  StepGraph& operator=(StepGraph&&) = delete;
  ~StepGraph() { drop(); }

  /// Records what `launches` launches on the stream, and runs none of it.
  /// @throws std::runtime_error when it cannot be recorded, which leaves no graph
  template <class Launches>
  void record(const Stream& stream, const Launches& launches) {
    Recording recording(stream.get());
    launches();
    recording.end();
    ++traffic().graphs_recorded;
    if (graph_ != nullptr && takes_arguments_of(recording.recorded)) return;
    drop();
    check_cuda(cudaGraphInstantiate(&graph_, recording.recorded, 0), "making a graph");
    ++traffic().graphs_made;
  }

  void launch(const Stream& stream) {
    check_cuda(cudaGraphLaunch(graph_, stream.get()), "launching a graph");
    ++traffic().graph_launches;
  }

 private:
  /// While it lives, launches on the stream are recorded.
  struct Recording {
    explicit Recording(cudaStream_t on) : stream(on) {
      check_cuda(cudaStreamBeginCapture(on, cudaStreamCaptureModeThreadLocal), "recording a graph");
      open = true;
    }
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;
    ~Recording() {
      if (open) cudaStreamEndCapture(stream, &recorded);
      if (recorded != nullptr) cudaGraphDestroy(recorded);
      cudaGetLastError();  // of a record that failed, which has been reported
    }
    void end() {
      open = false;
      check_cuda(cudaStreamEndCapture(stream, &recorded), "recording a graph");
    }
    cudaStream_t stream;
    cudaGraph_t recorded = nullptr;
    bool open = false;
  };

  bool takes_arguments_of(cudaGraph_t record) {
    cudaGraphExecUpdateResultInfo result{};
    const bool taken = cudaGraphExecUpdate(graph_, record, &result) == cudaSuccess;
    if (!taken) cudaGetLastError();  // other kernels, as when a list was empty: not an error
    return taken;
  }
  void drop() {
    if (graph_ != nullptr) cudaGraphExecDestroy(std::exchange(graph_, nullptr));
  }

  cudaGraphExec_t graph_ = nullptr;
};

}  // namespace gyro
