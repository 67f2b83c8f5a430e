// SPDX-License-Identifier: Apache-2.0
// Computes the current that an output with a limited voltage drives through a load (AX130751, chapter 4).
#pragma once

#include "devices/ax130751/firmware/quotient.hpp"

namespace canproof::ax130751 {

/// Returns the current that flows when `commanded` is requested: `commanded` itself, but at most what `compliance_v`
/// drives through the load. `per_ampere` gives the unit of both currents: 1000 for mA.
inline double loop_current(const double commanded, const double load_ohm, const double compliance_v,
                           const double per_ampere) noexcept {
    const bool limited = (load_ohm * commanded) > (compliance_v * per_ampere);
    return limited ? quotient(compliance_v * per_ampere, load_ohm) : commanded;
}

}  // namespace canproof::ax130751
