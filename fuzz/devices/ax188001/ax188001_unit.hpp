// The AX188001 for DeviceWorld.
#pragma once

#include "devices/ax188001/firmware/ax188001.hpp"
#include "fuzz/support/require.hpp"

namespace canproof::fuzz {

struct Ax188001Unit {
    using Device = ax188001::Device;
    using Inputs = ax188001::Inputs;
    using FactoryData = ax188001::FactoryData;
    static constexpr std::size_t memory_size = 1024;
    static constexpr std::uint8_t answers_remote = 0;

    static void prepare(Inputs&) {}
    static bool has_values(const Device&) { return true; }
    static bool shows_beyond_limits(const ObjectDictionary&, const EntryRef&) { return false; }
    /// 5555h = 2 starts all other nodes (3.4.20).
    static bool may_also_send(const Frame& frame) {
        return frame.id == 0 && frame.length == 2 && frame.data[0] == 1 && frame.data[1] == 0;
    }
    static bool keeps_outputs(const Device&, const Inputs&) { return false; }  ///< through a reset of the node

    /// 1.1, 3.2.4, 3.3.6, 3.4.13 to 3.4.19.
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
        }
        check_value(read(0x2100, 0), read(0x2130, 0));
        require(read(0x5042, 1) <= read(0x5041, 1) && read(0x5042, 2) <= read(0x5041, 2));
        require(read(0x5041, 3) <= read(0x5042, 3) && read(0x5042, 3) <= read(0x5042, 2));
        require(read(0x1003, 0) <= 9 && read(0x1001, 0) <= 1);
        require(read(0x1001, 0) == 1 || read(0x1003, 0) == 0);
    }

  private:
    /// A sentinel in the process value goes with FFC00000h in the field value, and the other way round.
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
