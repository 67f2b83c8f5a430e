// SPDX-License-Identifier: Apache-2.0
// Test fixture for the binary functions of the AX060805 (manual, 3.8).
#pragma once

#include "tests/devices/ax060805/inclinometer_bench.hpp"

namespace canproof::test {

/// The ten binary functions of a booted device whose input filter is off.
class InclinometerFunctions : public InclinometerTest {
  protected:
    static constexpr int undefined = -9999;

    void SetUp() override {
        InclinometerTest::SetUp();
        switch_filter_off();
    }
    static std::uint16_t at(int function, int parameter) {
        return static_cast<std::uint16_t>(0x3000 + 0x10 * function + parameter);
    }
    void connect(int function, std::uint8_t input, std::uint32_t source) { write(at(function, 0), input, source, 1); }
    void give_default(int function, std::uint8_t input, float value) {
        write(at(function, 1), input, 1, 1);
        write_real(at(function, 2), input, value);
    }
    void operate(int function, std::uint32_t operation) {
        write(0x300A, static_cast<std::uint8_t>(function), operation, 1);
    }
    void scale_output(int function, float scale) { write_real(0x300B, static_cast<std::uint8_t>(function), scale); }
    /// Returns the value of `source` times `scale`, as function 1 gives it; -9999 while the source is undefined.
    int taken_from(std::uint32_t source, float scale) {
        operate(1, 1);
        connect(1, 1, source);
        give_default(1, 1, -9999.0F / scale);
        give_default(1, 2, 0.0F);
        scale_output(1, scale);
        pass(5);
        return output(1);
    }
    int output(int function) { return value(0x3000, static_cast<std::uint8_t>(function)); }
};

}  // namespace canproof::test
