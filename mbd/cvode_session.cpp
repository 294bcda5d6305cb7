// SPDX-License-Identifier: GPL-3.0-or-later
#include "mbd/cvode_session.hpp"

#include "core/base/errors.hpp"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <string>
#include <utility>

namespace gyro {
namespace {

static_assert(sizeof(realtype) == sizeof(double), "SUNDIALS must be built for double precision");

constexpr long max_steps = 100000;  // per interval; a run-up of minutes takes some hundreds

void require(int flag, const char* call) {
  if (flag >= 0) return;
  const std::string name = std::to_string(flag);
  throw StoppedByGuard(std::string("the drivetrain's equations could not be integrated: ") + call + " returned " +
                       name + "; check inertia, motor and load");
}

std::span<double> values(N_Vector vector) {
  return {NV_DATA_S(vector), static_cast<std::size_t>(NV_LENGTH_S(vector))};
}

bool finite(std::span<const double> y) {
  return std::all_of(y.begin(), y.end(), [](double value) { return std::isfinite(value); });
}

/// Silences CVODE, which prints warnings on standard error; failures are also returned as flags.
void say_nothing(int, const char*, const char*, char*, void*) {}

/// Owns a SUNDIALS object of type T, freed by `release`.
template <class T, auto release>
class Owned {
 public:
  explicit Owned(T object) : object_(object) {
    if (!object_) throw StoppedByGuard("SUNDIALS could not allocate its memory; free some memory");
  }
  ~Owned() { release(object_); }
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  operator T() const { return object_; }

 private:
  T object_;
};

SUNContext create_context() {
  SUNContext context = nullptr;
  return SUNContext_Create(nullptr, &context) == 0 ? context : nullptr;
}
void free_context(SUNContext context) {
  SUNContext_Free(&context);
}
void free_memory(void* memory) {
  CVodeFree(&memory);
}

}  // namespace

struct CvodeSession::Implementation {
  Rate rate;
  Events events;
  int event_count;
  double first_step;
  std::exception_ptr thrown;  ///< by rate or event; C code must not see it
  Owned<SUNContext, free_context> context;
  Owned<N_Vector, N_VDestroy> y, tolerance;
  Owned<SUNMatrix, SUNMatDestroy> matrix;
  Owned<SUNLinearSolver, SUNLinSolFree> solver;
  Owned<void*, free_memory> memory;

  Implementation(const Settings& settings, Rate rate_of, Events events_of, int count);

  /// Calls `work`; stores an exception of it and returns CVODE's code for an unrecoverable error.
  template <class Work>
  int guarded(Work work) {
    try {
      work();
      return 0;
    } catch (...) {
      thrown = std::current_exception();
      return -1;
    }
  }
  static int call_rate(realtype, N_Vector y, N_Vector rate, void* self) {
    auto& me = *static_cast<Implementation*>(self);
    return me.guarded([&] { me.rate(values(y), values(rate)); });
  }
  static int call_events(realtype, N_Vector y, realtype* value, void* self) {
    auto& me = *static_cast<Implementation*>(self);
    return me.guarded([&] { me.events(values(y), {value, static_cast<std::size_t>(me.event_count)}); });
  }
};

CvodeSession::Implementation::Implementation(const Settings& settings, Rate rate_of, Events events_of, int count)
    : rate(std::move(rate_of)),
      events(std::move(events_of)),
      event_count(count),
      first_step(settings.first_step),
      context(create_context()),
      y(N_VNew_Serial(settings.size, context)),
      tolerance(N_VNew_Serial(settings.size, context)),
      matrix(SUNDenseMatrix(settings.size, settings.size, context)),
      solver(SUNLinSol_Dense(y, matrix, context)),
      memory(CVodeCreate(CV_BDF, context)) {
  std::ranges::copy(settings.absolute_tolerance, values(tolerance).begin());
  N_VConst(0, y);
  require(CVodeInit(memory, call_rate, 0, y), "CVodeInit");
  require(CVodeSVtolerances(memory, settings.relative_tolerance, tolerance), "CVodeSVtolerances");
  require(CVodeSetUserData(memory, this), "CVodeSetUserData");
  require(CVodeSetLinearSolver(memory, solver, matrix), "CVodeSetLinearSolver");
  require(CVodeSetMaxNumSteps(memory, max_steps), "CVodeSetMaxNumSteps");
  require(CVodeSetErrHandlerFn(memory, say_nothing, nullptr), "CVodeSetErrHandlerFn");
  if (event_count > 0) {
    require(CVodeRootInit(memory, event_count, call_events), "CVodeRootInit");
    require(CVodeSetNoInactiveRootWarn(memory), "CVodeSetNoInactiveRootWarn");
  }
}

CvodeSession::CvodeSession(const Settings& settings, Rate rate, Event event)
    : CvodeSession(
          settings, std::move(rate),
          [event](std::span<const double> y, std::span<double> value) { value[0] = event(y); }, event ? 1 : 0) {}
CvodeSession::CvodeSession(const Settings& settings, Rate rate, Events events, int event_count)
    : implementation_(std::make_unique<Implementation>(settings, std::move(rate), std::move(events), event_count)),
      fired_(static_cast<std::size_t>(event_count)) {}
CvodeSession::~CvodeSession() = default;
CvodeSession::CvodeSession(CvodeSession&&) noexcept = default;
CvodeSession& CvodeSession::operator=(CvodeSession&&) noexcept = default;

double CvodeSession::integrate(double duration, std::span<double> y) {
  Implementation& cvode = *implementation_;
  if (!finite(y)) throw StoppedByGuard("the drivetrain's state is not finite; check the load on the mantle");
  std::ranges::copy(y, values(cvode.y).begin());
  require(CVodeReInit(cvode.memory, 0, cvode.y), "CVodeReInit");
  require(CVodeSetInitStep(cvode.memory, cvode.first_step * duration), "CVodeSetInitStep");
  require(CVodeSetStopTime(cvode.memory, duration), "CVodeSetStopTime");

  double time = 0;
  const int flag = CVode(cvode.memory, duration, cvode.y, &time, CV_NORMAL);
  if (cvode.thrown) std::rethrow_exception(std::exchange(cvode.thrown, nullptr));
  require(flag, "CVode");
  if (!finite(values(cvode.y)))
    throw StoppedByGuard("the drivetrain's speed is not finite; check the load on the mantle");
  std::ranges::copy(values(cvode.y), y.begin());
  note_roots(flag == CV_ROOT_RETURN);
  return flag == CV_ROOT_RETURN ? time : duration;
}

void CvodeSession::note_roots(bool found) {
  std::vector<int> roots(fired_.size(), 0);
  if (found) require(CVodeGetRootInfo(implementation_->memory, roots.data()), "CVodeGetRootInfo");
  for (std::size_t k = 0; k < roots.size(); ++k) fired_[k] = roots[k] != 0;
}

long CvodeSession::rate_evaluations() const {
  long evaluations = 0;
  require(CVodeGetNumRhsEvals(implementation_->memory, &evaluations), "CVodeGetNumRhsEvals");
  return evaluations;
}

}  // namespace gyro
