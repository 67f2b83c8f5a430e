// SPDX-License-Identifier: Apache-2.0
// Fastscan: an LSS master finds the address of one slave without node-ID, number by number and bit by bit (CiA 305,
// 6.7).
#pragma once

#include <array>

#include "firmware/canopen/frame.hpp"
#include "generated/canopen/enumerations.hpp"

namespace canproof {

using generated::canopen::LssNumber;

/// How many numbers an LSS address has: vendor-ID, product code, revision number and serial number (see LssNumber).
constexpr std::uint32_t lss_number_count = 4U;

class LssFastscan {
  public:
    /// The eight bytes of the master's frame.
    using Request = std::array<std::uint8_t, max_frame_length>;
    enum class Outcome : std::uint8_t {
        silent,    ///< another slave is addressed, or the request is invalid; no answer
        matched,   ///< answered
        completed  ///< answered; all four numbers are confirmed
    };

    /// Expects the vendor-ID next; none of the four numbers is confirmed.
    void restart() noexcept;
    /// Returns the number that the master is expected to ask for, as an LssNumber.
    std::uint32_t position() const noexcept { return position_; }
    /// Processes one request: command specifier, number, bit check, position of this number, position of the next one.
    /// `own` is the device's number at position().
    Outcome scan(const Request& request, std::uint32_t own) noexcept;

    /// Returns whether the invariant between two requests holds (properties/invariants): the scan is at one of the four
    /// numbers of the LSS address, and not all four are confirmed.
    bool is_consistent() const noexcept;

  private:
    /// Returns whether the number in the request equals `own` from bit 31 down to the bit that "bit check" (at most 31)
    /// names.
    static bool matches(const Request& request, std::uint32_t own) noexcept;
    Outcome confirm(std::uint8_t next) noexcept;

    std::uint8_t position_{0U};
    std::uint32_t confirmed_{0U};  ///< a bit for each number that matched in all bits
};

}  // namespace canproof
