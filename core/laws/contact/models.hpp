// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laws/contact/contact_load.hpp"
#include "core/laws/contact/hertz.hpp"
#include "core/laws/contact/hysteretic.hpp"
#include "core/scene/contact_model.hpp"

namespace gyro {

namespace contact_detail {

/// Calls Law::energy() for the law that it is called with: a struct, because device code has no generic lambdas.
template <class T>
struct EnergyOf {
  const ContactConstants<T>& constants;
  T radius, overlap;
  const ContactHistory<T>& history;
  const ExtraHistory<T>* extra;

  template <class Law>
  GYRO_HD T operator()(Law) const {
    if constexpr (Law::keeps_extra_history) return Law::energy(constants, radius, overlap, history, *extra);
    return Law::energy(constants, radius, overlap, history, ExtraHistory<T>{});
  }
};

GYRO_ANY_CALLEE
template <class Normal, class F>
GYRO_HD auto with_rolling(RollingModel model, const F& f) {
  switch (model) {
    case RollingModel::off:
      return f(ContactLaw<Normal, NoRolling>{});
    case RollingModel::spring_dashpot:
      return f(ContactLaw<Normal, SpringDashpotRolling>{});
    case RollingModel::constant:
      break;
  }
  return f(ContactLaw<Normal, ConstantRolling>{});
}

struct StiffnessOf {
  const ContactConstants<double>& constants;
  double radius, overlap;

  template <class Law>
  GYRO_HD ContactStiffness operator()(Law) const {
    return Law::stiffness(constants, radius, overlap);
  }
};

}  // namespace contact_detail

/// The one list of contact laws: calls f with the law of a model, as a type. At launch, or where an account is taken;
/// never in a loop over contacts of a step.
GYRO_ANY_CALLEE
template <class F>
GYRO_HD auto with_contact_law(ContactModel model, const F& f) {
  if (model.normal == NormalModel::hysteretic) return contact_detail::with_rolling<Hysteretic>(model.rolling, f);
  return contact_detail::with_rolling<Hertz>(model.rolling, f);
}

/// Whether the law of a model keeps ExtraHistory.
inline bool keeps_extra_history(ContactModel model) {
  return with_contact_law(model, []<class Law>(Law) { return Law::keeps_extra_history; });
}

/// Elastic energy of a contact under the law of a model [J].
/// @param radius   R* [m]
/// @param overlap  as in ContactLaw::energy() [m]
/// @param extra    not read unless the law keeps it
template <class T>
GYRO_HD T contact_energy(ContactModel model, const ContactConstants<T>& constants, T radius, T overlap,
                         const ContactHistory<T>& history, const ExtraHistory<T>* extra) {
  return with_contact_law(model, contact_detail::EnergyOf<T>{constants, radius, overlap, history, extra});
}

/// What the contact asks of the step.
/// @param radius  R* [m]
GYRO_HD inline ContactStiffness contact_stiffness(ContactModel model, const ContactConstants<double>& constants,
                                                  double radius, double overlap) {
  return with_contact_law(model, contact_detail::StiffnessOf{constants, radius, overlap});
}

}  // namespace gyro
