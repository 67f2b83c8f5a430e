// SPDX-License-Identifier: Apache-2.0
// Computes the current that an output with a limited voltage drives through a load (AX130751, chapter 4).
#pragma once

namespace canproof::ax130751 {

/// Returns the current in mA. `per_ampere` converts volts divided by ohms to that unit.
constexpr double loop_current(const double commanded, const double load_ohm, const double compliance_v,
                              const double per_ampere) noexcept {
    const bool limited = (load_ohm * commanded) > (compliance_v * per_ampere);
    return limited ? ((compliance_v * per_ampere) / load_ohm) : commanded;
}

}  // namespace canproof::ax130751
