// SPDX-License-Identifier: Apache-2.0
// A test fixture (bench) with the conformance slave.
#pragma once

#include "tests/support/frame_bench.hpp"
#include "tests/support/slave.hpp"

namespace canproof::test {

/// A bench whose slave is node 5 and has every service. send() returns the answers as texts like
/// `585#6000200100000000`.
class SlaveBench : public FrameBench<host::GenericDevice> {
  public:
    static constexpr std::uint16_t program_index = 0x2400;  ///< the index of the DOMAIN object, whose memory the slave
                                                            ///< provides
    static constexpr std::size_t program_size = 65536;

    SlaveBench() : FrameBench{4096} { power_on(); }

    /// Creates a new slave on the memory of the previous one and powers it on, as in a power cycle. Returns the frames
    /// that it sends.
    Frames power_on() {
        queue = TransmitQueue{};
        device = std::make_unique<host::GenericDevice>(slave(), memory, queue);
        device->lend(program_index, 0, program_size);
        return switch_on([this] { device->power_on(LssConfiguration{node_id}, now, can_state, overrun); });
    }

    std::uint8_t node_id{5};
    // State of the CAN controller at power-on.
    std::uint8_t can_state{0};
    bool overrun{false};
};

}  // namespace canproof::test
