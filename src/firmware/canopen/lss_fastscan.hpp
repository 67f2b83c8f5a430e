// Fastscan: an LSS master finds the address of one slave without node-ID, number by number and bit by bit (CiA 305,
// 6.7).
#pragma once

#include <array>

#include "firmware/canopen/frame.hpp"
#include "generated/canopen/enumerations.hpp"

namespace canproof {

using generated::canopen::LssNumber;

/// Vendor-ID, product code, revision and serial number, by LssNumber.
constexpr std::uint32_t lss_number_count = 4U;

class LssFastscan {
  public:
    /// The eight bytes of the master's frame.
    using Request = std::array<std::uint8_t, max_frame_length>;
    enum class Outcome : std::uint8_t {
        silent,    ///< not this slave, or no sound request
        matched,   ///< to be answered
        completed  ///< to be answered; all four numbers are confirmed
    };

    /// The vendor-ID is asked for next, and nothing is confirmed.
    void restart() noexcept;
    /// Which number the master is expected to ask for.
    std::uint32_t position() const noexcept { return position_; }
    /// One request: command specifier, number, bit check, which number this is, which is next. `own`: the number at
    /// position().
    Outcome scan(const Request& request, std::uint32_t own) noexcept;

  private:
    /// Bits 31 down to the bit check, which is at most 31, are those of `own`.
    static bool matches(const Request& request, std::uint32_t own) noexcept;
    Outcome confirm(std::uint8_t next) noexcept;

    std::uint8_t position_{0U};
    std::uint32_t confirmed_{0U};  ///< a bit for each number that matched in all bits
};

}  // namespace canproof
