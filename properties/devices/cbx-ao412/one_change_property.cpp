// SPDX-License-Identifier: Apache-2.0
// Changes one value of a running CAN-CBX-AO412 at a time and compares its outputs with those of a device that had all
// values from the start (manual, 4.3.1, 7.10, 7.11).
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include "generated/cbx_ao412/requirements.hpp"
#include "properties/devices/cbx-ao412/ao4_scenario.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// The values of 6411h (output value), 2404h (offset) and 2405h (gain) of each of the four outputs.
using Ao4Values = std::array<std::array<int, 4>, 3>;

void write_value(CbxBench& bench, std::size_t which, std::size_t output, int value) {
    constexpr std::array<unsigned, 3> indices{0x6411, 0x2404, 0x2405};
    const auto bits = static_cast<std::uint16_t>(value);
    bench.send(frame_of(ao4_write(indices[which], static_cast<unsigned>(output) + 1, 2, bits), 3).text());
}

}  // namespace

RC_GTEST_PROP(CbxAo412OneChange, DeviceAfterEachWriteOfOneValueMatchesAFreshDeviceWithTheSameValues, ()) {
    verifies<req::AO4_AOUT_004, req::AO4_AOUT_005, req::AO4_AOUT_011>("property");
    const auto changes = *rc::gen::container<std::vector<std::array<int, 3>>>(
        8, rc::gen::container<std::array<int, 3>>(rc::gen::inRange(0, 60000)));
    Ao4Values values{{{8192, -3000, 500, 31000}, {8, -40, 160, 0}, {44, 0, -777, 16384}}};
    CbxBench running;
    running.power_on();
    for (std::size_t i = 0; i < 12; ++i) {
        write_value(running, i / 4, i % 4, values[i / 4][i % 4]);
    }
    for (const auto& numbers : changes) {
        const auto which = static_cast<std::size_t>(numbers[0] % 3);
        const auto output = static_cast<std::size_t>(numbers[1] % 4);
        const int value = which == 1 ? numbers[2] % 800 - 400 : numbers[2] - 30000;
        values[which][output] = value;
        write_value(running, which, output, value);
        CbxBench fresh;
        fresh.power_on();
        for (std::size_t i = 0; i < 12; ++i) {
            write_value(fresh, 2 - i / 4, i % 4, values[2 - i / 4][i % 4]);
        }
        RC_ASSERT(running.device->outputs().aout == fresh.device->outputs().aout);
    }
}

}  // namespace canproof::test
