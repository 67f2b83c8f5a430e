// SPDX-License-Identifier: Apache-2.0
// Test fixture of an AX188001, with thermocouples that follow the ITS-90 functions of its90.hpp.
#pragma once

#include <array>

#include "devices/ax188001/firmware/ax188001.hpp"
#include "tests/devices/ax188001/its90.hpp"
#include "tests/support/device_bench.hpp"

namespace canproof::test {

constexpr std::uint32_t too_high = 0x06090031;
constexpr std::uint32_t too_low = 0x06090032;
constexpr std::uint32_t out_of_range = 0x06090030;
constexpr std::uint32_t read_only = 0x06010002;
constexpr std::uint32_t no_object = 0x06020000;
constexpr std::uint32_t no_subindex = 0x06090011;
constexpr std::uint32_t not_a_number = 0xFFC00000;
constexpr std::uint32_t save = 0x65766173;  // the signature for 1010h (store parameters)

/// A device as node 127. The cold junction has 25 degC and the terminals have no voltage, so both channels read 25
/// degC.
class TcsBench : public DeviceBench<ax188001::Device, ax188001::Inputs, ax188001::FactoryData> {
  public:
    static constexpr std::uint64_t period_ms = 165;

    TcsBench() : DeviceBench{1024, 127} {}

    /// Sets the hot junction of a thermocouple of type `letter` to `celsius`.
    Frames heat(int channel, double celsius, char letter = 'J') {
        for (const auto& type : its90_types()) {
            if (type.letter == letter) {
                const long double mv = type.mv(static_cast<long double>(celsius)) - type.mv(inputs.cold_junction);
                inputs.tc_microvolts[index(channel)] = static_cast<float>(mv * 1000.0L);
            }
        }
        return set_inputs();
    }
    Frames cut(int channel, bool broken = true) {
        inputs.tc_open[index(channel)] = broken;
        return set_inputs();
    }
    Frames microvolts(int channel, double uv) {
        inputs.tc_microvolts[index(channel)] = static_cast<float>(uv);
        return set_inputs();
    }
    /// Advances the device to its next reading.
    Frames read_once() { return pass(period_ms); }
    /// Advances the device by nine readings, enough for two changes of the gain.
    Frames settle() { return pass(9 * period_ms); }

    SdoAnswer field_value(int channel) { return read(0x6100, channel); }
    int process_value(int channel) { return read(0x7130, channel).word(); }
    int status(int channel) { return static_cast<int>(read(0x6150, channel).value); }
    /// Makes TPDO `number` + 1 valid. It carries four 16-bit values. Without an event timer (0 ms), 18xxh:5 stays as it
    /// is.
    void carry_four_values(int number, std::uint32_t event_timer_ms = 0) {
        const std::uint32_t cob_id = 0x400001FFU + (static_cast<std::uint32_t>(number) * 0x100U);
        write(0x1800 + number, 1, 4, 0x80000000U | cob_id);
        write(0x1A00 + number, 0, 1, 0);
        const std::array<std::uint32_t, 4> values{0x71300110, 0x71300210, 0x21300010, 0x31300010};
        for (int line = 1; line <= 4; ++line) {
            write(0x1A00 + number, line, 4, values[index(line)]);
        }
        write(0x1A00 + number, 0, 1, 4);
        if (event_timer_ms != 0) {
            write(0x1800 + number, 5, 2, event_timer_ms);
        }
        EXPECT_EQ(write(0x1800 + number, 1, 4, cob_id), 0U);
    }
    /// Returns the errors listed in 1003h, the latest first.
    std::vector<std::uint32_t> listed() {
        std::vector<std::uint32_t> all;
        const int count = static_cast<int>(read(0x1003, 0).value);
        for (int sub = 1; sub <= count; ++sub) {
            all.push_back(read(0x1003, sub).value);
        }
        return all;
    }

  private:
    static std::size_t index(int channel) { return static_cast<std::size_t>(channel - 1); }
};

/// A test fixture whose device has booted at time 0, so readings are at multiples of 165 ms.
class TcsTest : public testing::Test, public TcsBench {
  protected:
    void SetUp() override { power_on(); }
};

}  // namespace canproof::test
