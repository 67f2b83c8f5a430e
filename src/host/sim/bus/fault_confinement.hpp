// SPDX-License-Identifier: Apache-2.0
// The error counters of a CAN controller and the states that follow from them (ISO 11898-1, fault confinement).
#pragma once

#include <cstdint>

#include "firmware/canopen/node.hpp"

namespace canproof::host {

class FaultConfinement {
  public:
    void transmitted() { transmit_ -= transmit_ > 0U ? 1U : 0U; }
    void received() { receive_ = receive_ >= passive_at ? back_to_active : receive_ - (receive_ > 0U ? 1U : 0U); }
    void transmit_failed() { transmit_ += transmit_penalty; }
    void receive_failed() { receive_ += receive_ <= most_counted ? 1U : 0U; }
    void switch_off() { transmit_ = bus_off_at; }
    /// Ends the bus-off state and clears both counters. The caller must first wait for 128 × 11 recessive bits.
    void recover() { transmit_ = receive_ = 0U; }

    CanState state() const {
        const std::uint32_t worst = transmit_ > receive_ ? transmit_ : receive_;
        return transmit_ >= bus_off_at ? CanState::bus_off
               : worst >= passive_at   ? CanState::error_passive
               : worst >= warning_at   ? CanState::warning
                                       : CanState::error_active;
    }
    std::uint32_t transmit_errors() const { return transmit_; }
    std::uint32_t receive_errors() const { return receive_; }

  private:
    static constexpr std::uint32_t transmit_penalty = 8U;
    static constexpr std::uint32_t warning_at = 96U;
    static constexpr std::uint32_t passive_at = 128U;
    static constexpr std::uint32_t bus_off_at = 256U;
    // ISO 11898-1 lets the controller choose a value from 119 to 127
    static constexpr std::uint32_t back_to_active = 119U;
    static constexpr std::uint32_t most_counted = 255U;

    std::uint32_t transmit_{0U};
    std::uint32_t receive_{0U};
};

}  // namespace canproof::host
