// The conformance slave with an LSS configuration and habits of one's choice.
#pragma once

#include <memory>

#include "tests/support/slave_bench.hpp"

namespace canproof::test {

/// Starts as node 5 at 125 kbit/s, with the bit rates of CiA 305 and reset by nobody but its master.
class LssBench : public SlaveBench {
  public:
    LssBench() { start({5, 125000}); }

    /// A power cycle with this in the device's memory. Returns what it sends.
    Frames start(const LssConfiguration& stored) {
        queue = TransmitQueue{};
        host::GenericDescription description = slave();
        description.profile.lss = resets_itself ? LssProfile{ax_bit_rates, true} : host::standard_lss();
        device = std::make_unique<host::GenericDevice>(description, memory, queue);
        return switch_on([this, &stored] { device->power_on(stored, now, can_state, overrun); });
    }

    NmtState state() { return device->node().state(); }
    std::uint32_t bit_rate() const { return device->bit_rate(); }
    /// The LSS state, by a service that only LSS configuration has.
    bool is_configuring() { return !send("7E5#5E").empty(); }

    /// Started so, the device resets itself at the switch to LSS waiting, as the Axiomatic manuals say.
    bool resets_itself{false};
    // AX130751, Table 22
    static constexpr std::array<LssBitRate, 9> ax_bit_rates{
        {{0, 1000000}, {1, 666667}, {2, 500000}, {3, 250000}, {4, 125000}, {5, 0}, {6, 50000}, {7, 20000}, {8, 10000}}};
};

}  // namespace canproof::test
