// SPDX-License-Identifier: Apache-2.0
// Test fixture that writes and reads the objects of the function blocks of an AX130751, and its outputs.
#pragma once

#include <array>

#include "tests/devices/ax130751/ax130751_bench.hpp"

namespace canproof::test {

/// An AX130751 in NMT state operational, in which its outputs work. The tests write values at whole milliseconds; the
/// blocks use these values in the next cycle, 1 ms later.
class Ax130751Blocks : public Ax130751Test {
  protected:
    void SetUp() override {
        Ax130751Test::SetUp();
        start();
        pass(1);
    }

    void set8(std::uint16_t index, int sub, int value) {
        EXPECT_EQ(write(index, sub, value, 1), "") << place(index, sub);
    }
    void set16(std::uint16_t index, int sub, int value) {
        EXPECT_EQ(write(index, sub, value, 2), "") << place(index, sub);
    }
    void set32(std::uint16_t index, int sub, std::int64_t value) {
        EXPECT_EQ(write(index, sub, value, 4), "") << place(index, sub);
    }
    /// Returns the index of the object of lookup table 1 to 10 that lies `offset` behind its first one, 3yz0h (LT Input
    /// X-Axis Source).
    static std::uint16_t table_object(int table, int offset = 0) {
        return static_cast<std::uint16_t>((table == 10 ? 0x3100 : 0x3000 + (0x10 * table)) + offset);
    }
    /// Maps entries into a PDO, whose COB-ID is not valid while its mapping changes.
    void map(int index, const std::vector<std::int64_t>& entries) {
        const auto mapping = static_cast<std::uint16_t>(index);
        set8(mapping, 0, 0);
        for (std::size_t line = 0; line < entries.size(); ++line) {
            set32(mapping, static_cast<int>(line) + 1, entries[line]);
        }
        set8(mapping, 0, static_cast<int>(entries.size()));
    }
    /// Makes the node send all TPDOs, each with four values and before the others, `ms` milliseconds from now.
    void send_all_tpdos_after(int ms) {
        for (std::uint16_t number = 0; number < 4; ++number) {
            const auto parameter = static_cast<std::uint16_t>(0x1800 + number);
            set32(parameter, 1, 0xC0000094U - number);
            map(0x1A00 + number, {0x25000410, 0x25000310, 0x25000210, 0x25000110});
            set16(parameter, 5, ms);
            set32(parameter, 1, 0x40000094U - number);
        }
    }
    /// Maps 2250h:1 (Relay Blink Rate) into RPDO2, whose frames may have a value that is too high.
    void check_values_of_rpdo2() {
        map(0x1601, {0x22500110});
        set32(0x1401, 1, 0x4000037F);
    }
    int get8(std::uint16_t index, int sub) { return static_cast<int>(read(index, sub)); }
    int get16(std::uint16_t index, int sub) { return static_cast<std::int16_t>(read(index, sub)); }
    float get_real(std::uint16_t index) {
        const auto bits = static_cast<std::uint32_t>(read(index, 0));
        return bit_cast<float>(bits);
    }

    /// Disables the ramps of an output.
    void no_ramps(int output) {
        set16(0x2330, output, 0);
        set16(0x2331, output, 0);
    }
    /// Scales 2500h:`number` (EC Extra Received Process Value) from 0 to 100 without decimal digits. Read as ON or OFF,
    /// this value is then OFF at 0 and ON at 100.
    void extra_as_percent(int number) {
        set8(0x2502, number, 0);
        set16(0x2522, number, 100);
    }
    /// Sets extra received value `number` (2500h), which control source 1 (CANopen message) has under the number 3 +
    /// `number`.
    void extra(int number, int value) {
        set16(0x2500, number, value);
        pass(1);
    }
    void command(int output, int value) {
        set16(0x7300, output, value);
        pass(1);
    }

    float volts(int output) const { return device->outputs().out_voltage.at(at(output)); }
    float milliamperes(int output) const { return device->outputs().out_current.at(at(output)); }
    float duty(int output) const { return device->outputs().out_duty.at(at(output)); }
    float hertz(int output) const { return device->outputs().out_frequency.at(at(output)); }
    float level(int output) const { return device->outputs().out_level.at(at(output)); }
    bool is_on(int output) const { return device->outputs().out_on.at(at(output)); }
    /// Returns whether the relay is ON: then the common pin is connected to NC (section 1.4).
    bool relay_on() const { return device->outputs().relay_nc; }

    static std::string place(std::uint16_t index, int sub) { return fmt::format("{:04X}h:{}", index, sub); }
    static std::size_t at(int output) { return static_cast<std::size_t>(output - 1); }

    // Numbers of the control sources in Table 4A.
    static constexpr int not_used = 0;
    static constexpr int canopen = 1;
    static constexpr int lookup_source = 3;
    static constexpr int math_source = 4;
    static constexpr int logic_source = 5;
    static constexpr int supply_source = 8;
    static constexpr int temperature_source = 9;

    struct Choice {
        int source;
        int number;
    };
    /// Pairs of source and number without a value: Table 4B does not have the number, or the block of the source is off
    /// by default.
    static constexpr std::array<Choice, 9> without_value{{{canopen, 0},
                                                          {canopen, 10},
                                                          {lookup_source, 0},
                                                          {lookup_source, 1},
                                                          {logic_source, 1},
                                                          {math_source, 1},
                                                          {math_source, 5},
                                                          {2, 2},
                                                          {6, 3}}};
};

}  // namespace canproof::test
