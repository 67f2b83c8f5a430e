// SPDX-License-Identifier: Apache-2.0
// Describes the AX188001 for DeviceWorld (device_world.hpp).
#pragma once

#include <cmath>

#include "devices/ax188001/firmware/ax188001.hpp"
#include "fuzz/support/require.hpp"

namespace canproof::fuzz {

struct Ax188001Unit {
    using Device = ax188001::Device;
    using Inputs = ax188001::Inputs;
    using FactoryData = ax188001::FactoryData;
    static constexpr std::size_t memory_size = 1024;
    static constexpr std::uint8_t bus_node = 5;  ///< node-ID of this device on the bus of bus_fuzz.cpp
    static constexpr bool has_lss = true;
    static constexpr std::uint8_t answers_remote = 0;

    static void prepare(Inputs&) {}
    static bool has_values(const Device&) { return true; }
    static bool shows_beyond_limits(const ObjectDictionary&, const EntryRef&) { return false; }
    /// Returns whether a frame is the NMT command "start" to all nodes. The device sends it when 5555h (Start in
    /// Operational Mode) is 2 (3.4.22).
    static bool may_also_send(const Frame& frame) {
        return frame.id == 0 && frame.length == 2 && frame.data[0] == 1 && frame.data[1] == 0;
    }
    /// Returns false: no output keeps its value over a reset of the node.
    static bool keeps_outputs(const Device&, const Inputs&) { return false; }

    /// Checks values, faults and limits against the manual's sections 1.1, 3.2.4, 3.3.6 and 3.4.13 to 3.4.19.
    static void check(const Device& device, const Inputs&, bool) {
        const ObjectDictionary& objects = device.objects();
        const auto read = [&](std::uint16_t index, std::uint8_t sub) { return objects.read(index, sub); };
        const auto word = [&](std::uint16_t index, std::uint8_t sub) {
            return int{static_cast<std::int16_t>(objects.read(index, sub))};
        };
        for (std::uint8_t sub = 1; sub <= 2; ++sub) {
            const auto status = read(0x6150, sub);
            require(status == 0 || (status >= 2 && status <= 5));
            const int high = word(0x4010, sub);
            const int shutdown = word(0x4020, sub);
            require(word(0x4000, sub) >= -2730 && word(0x4000, sub) <= high - 100);
            require(high <= shutdown - 100 && shutdown <= 17350);
            check_value(read(0x6100, sub), read(0x7130, sub));
            check_scaling(objects, Scaled{0x6100, 0x7130, 0x6126, 0x6127, sub, true});
            const bool tells =
                device.state() != NmtState::initialising;  // without a node-ID the device reports nothing
            require(status == 0 || !tells || read(0x1001, 0) == 1);
        }
        check_value(read(0x2100, 0), read(0x2130, 0));
        check_scaling(objects, Scaled{0x2100, 0x2130, 0x2126, 0x2127, 0, true});
        check_scaling(objects, Scaled{0x3100, 0x3130, 0x3126, 0x3127, 0, false});
        check_average(objects);
        require(read(0x5042, 1) <= read(0x5041, 1) && read(0x5042, 2) <= read(0x5041, 2));
        require(read(0x5041, 3) <= read(0x5042, 3) && read(0x5042, 3) <= read(0x5042, 2));
        require(read(0x1003, 0) <= 9 && read(0x1001, 0) <= 1);
        require(read(0x1001, 0) == 1 || read(0x1003, 0) == 0);
    }

  private:
    static constexpr std::uint32_t not_a_number = 0xFFC00000;

    /// A field value, its process value, and the factor and the offset that convert one into the other (1.1 to 1.3),
    /// each by its object index.
    struct Scaled {
        std::uint16_t field;
        std::uint16_t process;
        std::uint16_t factor;
        std::uint16_t offset;
        std::uint8_t sub;
        bool gives_way;  ///< whether the process values -1 and -512, which are reserved, become 0 and -511
    };
    static void check_scaling(const ObjectDictionary& objects, const Scaled& at) {
        const auto real = [&](std::uint16_t index) {
            return static_cast<double>(bit_cast<float>(objects.read(index, at.sub)));
        };
        if (objects.read(at.field, at.sub) == not_a_number) {
            return;
        }
        const double exact = std::round(real(at.field) * real(at.factor) + real(at.offset));
        const double held = std::fmin(std::fmax(exact, -32768.0), 32767.0);
        const double moved = at.gives_way && (held == -1.0 || held == -512.0) ? held + 1.0 : held;
        require(static_cast<double>(static_cast<std::int16_t>(objects.read(at.process, at.sub))) == moved);
    }
    /// Checks the average: the mean of the channels that have a temperature (1.2).
    static void check_average(const ObjectDictionary& objects) {
        double sum = 0.0;
        int count = 0;
        for (std::uint8_t sub = 1; sub <= 2 && objects.read(0x2112, 0) != 0; ++sub) {
            const std::uint32_t bits = objects.read(0x6100, sub);
            sum += bits == not_a_number ? 0.0 : static_cast<double>(bit_cast<float>(bits));
            count += bits == not_a_number ? 0 : 1;
        }
        const std::uint32_t mean = objects.read(0x2100, 0);
        require((mean == not_a_number) == (count == 0));
        require(count == 0 || bit_cast<float>(mean) == static_cast<float>(sum / count));
    }
    /// Checks that the field value is FFC00000h (not a number) exactly when the process value is a reserved one.
    static void check_value(std::uint32_t field_value, std::uint32_t process_value) {
        const bool sentinel = process_value == 0xFFFF || process_value == 0xFE00;
        require(sentinel == (field_value == 0xFFC00000));
        if (!sentinel) {
            const auto celsius = bit_cast<float>(field_value);
            require(celsius >= -270.01F && celsius <= 1820.01F);
        }
    }
};

}  // namespace canproof::fuzz
