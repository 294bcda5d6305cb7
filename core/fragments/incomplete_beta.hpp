// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gyro {

/// Regularised incomplete beta function [-]:
///
///   I_x(a, b) = 1/B(a, b) integral from 0 to x of t^(a-1) (1-t)^(b-1) dt
///
/// By its continued fraction (NIST DLMF 8.17.22), evaluated by the modified method of Lentz (Thompson & Barnett,
/// J. Comput. Phys. 64 (1986) 490); for x > (a+1)/(a+b+2), where it converges slowly, as 1 - I_{1-x}(b, a). The error
/// is a few roundings for a and b up to 100.
/// @param x     from 0 to 1
/// @param a, b  > 0
double incomplete_beta(double x, double a, double b);

}  // namespace gyro
