// SPDX-License-Identifier: Apache-2.0
// A test fixture (bench) with the conformance slave, whose stored node-ID and bit rate and whose LSS behaviour a test
// can choose.
#pragma once

#include <memory>

#include "tests/support/slave_bench.hpp"

namespace canproof::test {

/// A bench whose slave starts as node 5 at 125 kbit/s. By default the slave has the bit rates of CiA 305, and only
/// a command of the NMT master resets it; `resets_itself` changes both.
class LssBench : public SlaveBench {
  public:
    LssBench() { start({5, 125000}); }

    /// Power-cycles the slave with `stored` as the configuration in its memory. Returns the frames that the slave
    /// sends.
    Frames start(const LssConfiguration& stored) {
        queue = TransmitQueue{};
        host::GenericDescription description = slave();
        description.profile.lss = resets_itself ? LssProfile{ax_bit_rates, true} : host::standard_lss();
        device = std::make_unique<host::GenericDevice>(description, memory, queue);
        return switch_on([this, &stored] { device->power_on(stored, now, can_state, overrun); });
    }

    NmtState state() { return device->node().state(); }
    std::uint32_t bit_rate() const { return device->bit_rate(); }
    /// Returns whether the slave is in the state LSS configuration: it answers `inquire node-ID` (5Eh) only in this
    /// state.
    bool is_configuring() { return !send("7E5#5E").empty(); }

    /// If true when start() is called, the slave resets itself at the switch to LSS waiting, as in the Axiomatic
    /// manuals.
    bool resets_itself{false};
    // AX130751, Table 22
    static constexpr std::array<LssBitRate, 9> ax_bit_rates{
        {{0, 1000000}, {1, 666667}, {2, 500000}, {3, 250000}, {4, 125000}, {5, 0}, {6, 50000}, {7, 20000}, {8, 10000}}};
};

}  // namespace canproof::test
