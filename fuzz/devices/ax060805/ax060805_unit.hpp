// SPDX-License-Identifier: Apache-2.0
// Describes the AX060805 for DeviceWorld (device_world.hpp).
#pragma once

#include "devices/ax060805/firmware/ax060805.hpp"
#include "fuzz/support/require.hpp"

namespace canproof::fuzz {

struct Ax060805Unit {
    using Device = ax060805::Device;
    using Inputs = ax060805::Inputs;
    using FactoryData = ax060805::FactoryData;
    static constexpr std::size_t memory_size = 4096;
    static constexpr std::uint8_t bus_node = 6;  ///< node-ID of this device on the bus of bus_fuzz.cpp
    static constexpr bool has_lss = true;
    static constexpr std::uint8_t answers_remote = 0;

    static void prepare(Inputs&) {}
    static bool has_values(const Device&) { return true; }
    static bool shows_beyond_limits(const ObjectDictionary&, const EntryRef&) { return false; }
    static bool may_also_send(const Frame&) { return false; }
    /// Returns false: no output keeps its value over a reset of the node.
    static bool keeps_outputs(const Device&, const Inputs&) { return false; }

    static void check(const Device& device, const Inputs&, bool) {
        const ObjectDictionary& objects = device.objects();
        require(objects.read(0x1003, 0) <= 4 && objects.read(0x1001, 0) <= 1);
        require(objects.read(0x4020, 0) <= 2 && objects.read(0x2300, 0) == 0);
    }
};

}  // namespace canproof::fuzz
