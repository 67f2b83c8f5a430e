// SPDX-License-Identifier: Apache-2.0
// The reaction of a switched output to its logic state (AX130751, Tables 1 and 10).
#pragma once

#include <array>
#include <cstdint>

#include "generated/ax130751/tables.hpp"

namespace canproof::ax130751 {

using SwitchDrive = generated::ax130751::digital_polarity::Drive;

/// The drive for the present logic state and that of the cycle before.
struct SwitchPolarity {
    std::array<SwitchDrive, 2U> was_off{{SwitchDrive::off, SwitchDrive::on}};  ///< for a present state of OFF, ON
    std::array<SwitchDrive, 2U> was_on{{SwitchDrive::off, SwitchDrive::on}};

    constexpr SwitchDrive drive(const bool before, const bool state) const noexcept {
        const std::size_t column = state ? 1U : 0U;
        return before ? was_on[column] : was_off[column];
    }
};

}  // namespace canproof::ax130751
