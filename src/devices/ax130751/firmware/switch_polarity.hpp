// SPDX-License-Identifier: Apache-2.0
// The reaction of a switched output to its logic state (AX130751, Tables 1 and 10).
#pragma once

#include <array>
#include <cstdint>

#include "generated/ax130751/enumerations.hpp"

namespace canproof::ax130751 {

/// The result of a polarity for the logic state of a switched output: OFF, ON, blinking, no change (`keep`), or a
/// change to the other state (`change`). `none` means a relay that is not implemented, and counts as OFF.
using SwitchDrive = generated::ax130751::SwitchDrive;

/// The SwitchDrive of an output for its logic state in the last cycle (`was_off`, `was_on`) and in the present cycle.
/// Position 0 of each array is for a present OFF, position 1 for a present ON.
struct SwitchPolarity {
    std::array<SwitchDrive, 2U> was_off{{SwitchDrive::off, SwitchDrive::on}};
    std::array<SwitchDrive, 2U> was_on{{SwitchDrive::off, SwitchDrive::on}};

    constexpr SwitchDrive drive(const bool before, const bool state) const noexcept {
        const std::size_t column = state ? 1U : 0U;
        return before ? was_on[column] : was_off[column];
    }
};

}  // namespace canproof::ax130751
