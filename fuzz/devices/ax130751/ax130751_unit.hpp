// SPDX-License-Identifier: Apache-2.0
// Describes the AX130751 for DeviceWorld (device_world.hpp).
#pragma once

#include "devices/ax130751/firmware/ax130751.hpp"
#include "fuzz/support/require.hpp"

namespace canproof::fuzz {

struct Ax130751Unit {
    using Device = ax130751::Device;
    using Inputs = ax130751::Inputs;
    using FactoryData = ax130751::FactoryData;
    static constexpr std::size_t memory_size = 8192;
    static constexpr std::uint8_t bus_node = 4;  ///< node-ID of this device on the bus of bus_fuzz.cpp
    static constexpr bool has_lss = true;
    static constexpr std::uint8_t answers_remote = 0;

    static void prepare(Inputs&) {}
    static bool has_values(const Device&) { return true; }
    /// Returns whether an entry shows a value that no SDO can write to it: 5B51h (Change Node ID) reads FFh when LSS
    /// has removed the node-ID.
    static bool shows_beyond_limits(const ObjectDictionary& objects, const EntryRef& entry) {
        return entry.is(0x5B51, 0) && objects.read(0x5B51, 0) == unconfigured_node_id;
    }
    static bool may_also_send(const Frame&) { return false; }
    /// Returns false: no output keeps its value over a reset of the node.
    static bool keeps_outputs(const Device&, const Inputs&) { return false; }

    /// Checks that each output stays within the widest range of all output types (1.3 Table 3, section 4). When the
    /// device is settled and the supply is outside 7 to 39 V, checks that it drives no output and no relay coil
    /// (AOR-D-283).
    static void check(const Device& device, const Inputs& inputs, bool settled) {
        const ax130751::Outputs& outputs = device.outputs();
        const bool shut = settled && !(inputs.supply >= 7.0F && inputs.supply <= 39.0F);
        require(outputs.relay_nc != outputs.relay_no);
        require(!(shut && outputs.relay_no));
        for (std::size_t i = 0; i < 2; ++i) {
            const float volts = outputs.out_voltage[i];
            require(volts >= -10.0F && volts <= 12.0F);
            require(outputs.out_current[i] >= 0.0F && outputs.out_current[i] <= 24.0F);
            require(outputs.out_duty[i] >= 0.0F && outputs.out_duty[i] <= 100.0F);
            require(outputs.out_frequency[i] >= 0.0F && outputs.out_frequency[i] <= 30000.0F);
            require(outputs.out_level[i] == 0.0F || outputs.out_level[i] == 5.0F || outputs.out_level[i] == 12.0F);
            require(!shut || (volts == 0.0F && outputs.out_current[i] == 0.0F && !outputs.out_on[i]));
        }
    }
};

}  // namespace canproof::fuzz
