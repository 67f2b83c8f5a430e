// SPDX-License-Identifier: Apache-2.0
// Test fixture of an AX060805: node 127 with default parameters, frames as in a candump log, positions in degrees.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "devices/ax060805/firmware/ax060805.hpp"
#include "tests/support/frame_bench.hpp"
#include "tests/support/sdo_text.hpp"

namespace canproof::test {

class InclinometerBench : public UnitBench<ax060805::Device, ax060805::Inputs, ax060805::FactoryData> {
  public:
    InclinometerBench() : UnitBench{4096} {}

    /// Sets the accelerations of a resting sensor in g; the next sample measures them.
    void feel(double x, double y, double z) {
        inputs.acceleration_x = static_cast<float>(x);
        inputs.acceleration_y = static_cast<float>(y);
        inputs.acceleration_z = static_cast<float>(z);
        device->set_inputs(inputs, now);
    }
    /// Sets the attitude that these Euler angles, in degrees, describe.
    void turn(double pitch, double roll) {
        constexpr double radians = 3.14159265358979323846 / 180.0;
        const double theta = pitch * radians;
        const double phi = roll * radians;
        feel(std::sin(theta), -std::sin(phi) * std::cos(theta), -std::cos(phi) * std::cos(theta));
    }

    /// Writes `bytes` bytes by SDO. Returns "" when the download was confirmed, else the abort code.
    std::string refusal(std::uint16_t index, std::uint8_t sub, std::uint32_t value, int bytes) {
        static const std::vector<std::string> specifier{"", "2F", "2B", "", "23"};
        const std::string at = hex_le(index, 2) + hex_le(sub, 1);
        const Frames answer = send(id(0x600) + specifier[static_cast<std::size_t>(bytes)] + at + hex_le(value, bytes) +
                                   std::string(static_cast<std::size_t>(8 - 2 * bytes), '0'));
        if (answer.size() != 1) {
            return fmt::format("{} answers", answer.size());
        }
        if (answer[0] == id(0x580) + "60" + at + "00000000") {
            return "";
        }
        const std::string code = answer[0].substr(answer[0].size() - 8);
        return code.substr(6, 2) + code.substr(4, 2) + code.substr(2, 2) + code.substr(0, 2);
    }
    /// Writes a value of `bytes` bytes by SDO and expects that it is accepted.
    void write(std::uint16_t index, std::uint8_t sub, std::uint32_t value, int bytes) {
        EXPECT_EQ(refusal(index, sub, value, bytes), "") << fmt::format("{:04X}h:{} = {}", index, sub, value);
    }
    void write_real(std::uint16_t index, std::uint8_t sub, float value) { write(index, sub, bits_of(value), 4); }
    std::uint32_t read(std::uint16_t index, std::uint8_t sub = 0) {
        const Frames answer = send(id(0x600) + "40" + hex_le(index, 2) + hex_le(sub, 1) + "00000000");
        if (answer.size() != 1 || answer[0].substr(0, 5) != id(0x580) + "4") {
            ADD_FAILURE() << fmt::format("{:04X}h:{} cannot be read", index, sub);
            return 0xDEADBEEF;
        }
        const std::string data = answer[0].substr(answer[0].size() - 8);
        return static_cast<std::uint32_t>(
            std::stoul(data.substr(6, 2) + data.substr(4, 2) + data.substr(2, 2) + data.substr(0, 2), nullptr, 16));
    }
    /// Reads an INTEGER16.
    int value(std::uint16_t index, std::uint8_t sub = 0) {
        return static_cast<std::int16_t>(static_cast<std::uint16_t>(read(index, sub)));
    }
    float real(std::uint16_t index, std::uint8_t sub = 0) {
        const std::uint32_t bits = read(index, sub);
        float number = 0.0F;
        std::memcpy(&number, &bits, sizeof number);
        return number;
    }
    static std::uint32_t bits_of(float value) {
        std::uint32_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        return bits;
    }
    /// Returns the identifier `base` + node-ID as text, followed by `#`.
    std::string id(unsigned base) const { return fmt::format("{:03X}#", base + node); }

    // The functions below return pitch, roll, gravity angle and accelerations in counts of their field values.
    int pitch() { return value(0x4030); }
    int roll() { return value(0x4040); }
    int gravity_angle() { return value(0x4050); }
    std::vector<int> angles() { return {pitch(), roll(), gravity_angle()}; }
    /// Sets these accelerations in g, waits for the next sample and returns pitch, roll and gravity angle.
    std::vector<int> angles_at(double x, double y, double z) {
        feel(x, y, z);
        pass(5);
        return angles();
    }
    std::vector<int> angles_of(double pitch, double roll) {
        turn(pitch, roll);
        pass(5);
        return angles();
    }
    void use_euler_angles() { write(0x2100, 0, 0, 1); }
    std::vector<int> accelerations() { return {value(0x4000, 1), value(0x4000, 2), value(0x4000, 3)}; }
    /// Sets 2030h (decimal digits) of the three angles; 100 gives hundredths of a degree.
    void angle_digits(std::uint32_t digits) {
        for (std::uint8_t sub = 1; sub <= 3; ++sub) {
            write(0x2030, sub, digits, 2);
        }
    }
    void acceleration_digits(std::uint32_t digits) {
        for (std::uint8_t sub = 1; sub <= 3; ++sub) {
            write(0x2010, sub, digits, 2);
        }
    }
    /// Switches the input filter off: every sample passes unchanged.
    void switch_filter_off() { write(0x2002, 0, 0, 1); }

    unsigned node{127};
};

/// A test fixture whose device has booted.
class InclinometerTest : public testing::Test, public InclinometerBench {
  protected:
    void SetUp() override { power_on(); }
};

}  // namespace canproof::test
