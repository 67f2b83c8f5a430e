// SPDX-License-Identifier: Apache-2.0
// The reaction of a switched output to its logic state (AX130751, Tables 1 and 10).
#pragma once

#include <array>
#include <cstdint>

#include "generated/ax130751/enumerations.hpp"

namespace canproof::ax130751 {

/// The drive of a switched output: on, off, blink, or none. `none` means a relay that is not implemented, and counts as
/// OFF.
using SwitchDrive = generated::ax130751::SwitchDrive;

/// The drive of an output, which depends on its logic state in the last cycle and in the present one. Position 0 of
/// each array is for a present OFF, position 1 for a present ON.
struct SwitchPolarity {
    std::array<SwitchDrive, 2U> was_off{{SwitchDrive::off, SwitchDrive::on}};
    std::array<SwitchDrive, 2U> was_on{{SwitchDrive::off, SwitchDrive::on}};

    constexpr SwitchDrive drive(const bool before, const bool state) const noexcept {
        const std::size_t column = state ? 1U : 0U;
        return before ? was_on[column] : was_off[column];
    }
};

}  // namespace canproof::ax130751
