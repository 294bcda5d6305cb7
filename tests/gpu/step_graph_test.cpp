// SPDX-License-Identifier: GPL-3.0-or-later
// The order of calls of the CUDA runtime, on a stand-in that notes them: it shows what is made and released, not that a
// driver accepts it.
#include "gpu/step_graph.hpp"

#include "tests/catch.hpp"

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

struct Runtime {
  std::vector<std::string> calls;
  bool takes_arguments = true, ends_well = true;
  std::uintptr_t made = 0;

  template <class Handle>
  void make(Handle* handle) {
    *handle = reinterpret_cast<Handle>(++made);
  }
  cudaError_t note(const char* call, bool good = true) {
    calls.push_back(call);
    return good ? cudaSuccess : cudaErrorUnknown;
  }
};
Runtime runtime;

using Calls = std::vector<std::string>;
/// Since they were last asked for.
Calls calls() {
  return std::exchange(runtime.calls, {});
}
void nothing() {}

}  // namespace

extern "C" {
cudaError_t cudaGetLastError() {
  return cudaSuccess;
}
const char* cudaGetErrorString(cudaError_t) {
  return "an error";
}
cudaError_t cudaStreamCreate(cudaStream_t* stream) {
  runtime.make(stream);
  return runtime.note("stream");
}
cudaError_t cudaStreamDestroy(cudaStream_t) {
  return runtime.note("drop stream");
}
cudaError_t cudaStreamBeginCapture(cudaStream_t, cudaStreamCaptureMode) {
  return runtime.note("begin");
}
cudaError_t cudaStreamEndCapture(cudaStream_t, cudaGraph_t* record) {
  if (runtime.ends_well) runtime.make(record);
  return runtime.note("end", runtime.ends_well);
}
cudaError_t cudaGraphInstantiate(cudaGraphExec_t* graph, cudaGraph_t, unsigned long long) {
  runtime.make(graph);
  return runtime.note("make");
}
cudaError_t cudaGraphExecUpdate(cudaGraphExec_t, cudaGraph_t, cudaGraphExecUpdateResultInfo*) {
  return runtime.note("update", runtime.takes_arguments);
}
cudaError_t cudaGraphDestroy(cudaGraph_t) {
  return runtime.note("drop record");
}
cudaError_t cudaGraphExecDestroy(cudaGraphExec_t) {
  return runtime.note("drop graph");
}
cudaError_t cudaGraphLaunch(cudaGraphExec_t, cudaStream_t) {
  return runtime.note("launch");
}
}

using namespace gyro;

TEST_CASE("A graph takes the arguments of later records, and is replaced where it cannot", "[gpu]") {
  runtime = {};
  {
    const Stream stream;
    StepGraph graph;
    graph.record(stream, [] { runtime.note("kernel"); });
    CHECK(calls() == Calls{"stream", "begin", "kernel", "end", "make", "drop record"});
    graph.launch(stream);
    CHECK(calls() == Calls{"launch"});
    graph.record(stream, nothing);
    CHECK(calls() == Calls{"begin", "end", "update", "drop record"});
    runtime.takes_arguments = false;
    graph.record(stream, nothing);
    CHECK(calls() == Calls{"begin", "end", "update", "drop graph", "make", "drop record"});
  }
  CHECK(calls() == Calls{"drop graph", "drop stream"});
}

TEST_CASE("A record that fails is ended and released, and the error is passed on", "[gpu]") {
  runtime = {};
  const Stream stream;
  StepGraph graph;
  calls();
  CHECK_THROWS_AS(graph.record(stream, [] { throw std::logic_error("a kernel cannot be launched"); }),
                  std::logic_error);
  CHECK(calls() == Calls{"begin", "end", "drop record"});
  runtime.ends_well = false;
  CHECK_THROWS_AS(graph.record(stream, nothing), std::runtime_error);
  CHECK(calls() == Calls{"begin", "end"});
}

TEST_CASE("Stream and graph are released once when an executor is moved", "[gpu]") {
  runtime = {};
  {
    Stream stream;
    StepGraph graph;
    graph.record(stream, nothing);
    const Stream now(std::move(stream));
    StepGraph moved(std::move(graph));
    calls();
    moved.launch(now);
  }
  CHECK(calls() == Calls{"launch", "drop graph", "drop stream"});
}
