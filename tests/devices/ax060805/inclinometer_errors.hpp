// SPDX-License-Identifier: Apache-2.0
// Test fixture for the errors of the AX060805, node 127. Its emergency messages have the COB-ID 0FFh.
#pragma once

#include <vector>

#include "tests/devices/ax060805/inclinometer_bench.hpp"

namespace canproof::test {

class Ax060805Errors : public InclinometerTest {
  protected:
    Frames fail_accelerometer(bool fails = true) {
        inputs.accelerometer_fault = fails;
        set_inputs();
        return pass(5);
    }
    Frames heat(float celsius) {
        inputs.sensor_temperature = celsius;
        set_inputs();
        return pass(5);
    }
    /// Returns the entries of 1003h (error list), the latest first.
    std::vector<std::uint32_t> listed() {
        std::vector<std::uint32_t> all;
        const std::uint32_t count = read(0x1003);
        for (std::uint8_t sub = 1; sub <= count; ++sub) {
            all.push_back(read(0x1003, sub));
        }
        return all;
    }
};

}  // namespace canproof::test
