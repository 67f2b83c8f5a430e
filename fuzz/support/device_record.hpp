// SPDX-License-Identifier: Apache-2.0
// Decodes the records of a fuzz input (device_world.hpp) whose meaning does not depend on the device's state.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "firmware/base/bytes.hpp"
#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "firmware/canopen/object_types.hpp"

namespace canproof::fuzz {

constexpr std::size_t device_record_size = 12;

/// Returns a data frame with the length in the low four bits of `how`, at most eight bytes.
inline Frame frame_of(std::uint32_t id, unsigned how, const std::uint8_t* data) {
    Frame frame = data_frame(id, static_cast<std::uint8_t>(std::min(how & 0x0FU, 8U)));
    std::copy_n(data, frame.length, frame.data.begin());
    return frame;
}

/// Returns a frame of any identifier; bit 7 of `how` makes it a remote frame, bit 6 a frame with a 29-bit identifier.
inline Frame any_frame(unsigned how, const std::uint8_t* data) {
    Frame frame = frame_of((data[0] + 256U * data[1]) & 0x7FFU, how, data + 2);
    frame.remote = (how & 0x80U) != 0;
    frame.extended = (how & 0x40U) != 0;
    return frame;
}

/// Returns an expedited write with the right length to the entry that `data` selects, so that the fuzzer varies values
/// rather than addresses. Returns nothing for an entry that does not have one to four bytes.
inline std::optional<Frame> entry_write(const DictionaryTables& tables, std::uint32_t node_id,
                                        const std::uint8_t* data) {
    const std::size_t chosen = (data[0] + 256U * data[1]) % tables.entries.count;
    const EntryRow& entry = tables.entries[chosen];
    for (const ObjectRow& object : tables.objects) {
        const bool holds = chosen >= object.first_entry && chosen < std::size_t{object.first_entry} + object.count;
        if (holds && entry.size >= 1 && entry.size <= 4) {
            Frame write = data_frame(0x600U + node_id, 8);
            write.data[0] = static_cast<std::uint8_t>(0x23U | ((4U - entry.size) << 2U));
            write_le(MutableBytes{write.data}, 1, 2, object.index);
            write.data[3] = entry.subindex;
            std::copy_n(data + 2, entry.size, write.data.begin() + 4);
            return write;
        }
    }
    return std::nullopt;
}

/// Returns the duration in a record of kind C (time passes): up to 10 s.
inline Duration duration_in(const std::uint8_t* record) {
    return milliseconds((record[2] + 256U * record[3]) % 10000U);
}

/// Returns a value of the type `Value` for a physical input. A floating-point number has any bits or is a plain decimal
/// value.
template <typename Value>
Value value_of(const std::uint8_t* data) {
    if constexpr (std::is_floating_point_v<Value>) {
        constexpr float scales[]{0.001F, 0.01F, 0.1F, 1.0F};
        const unsigned kind = data[4] % 8U;
        const float number = static_cast<float>(static_cast<std::int16_t>(data[0] | (unsigned{data[1]} << 8U)));
        return kind < 4 ? bit_cast<float>(read_u32(ByteView{data, 4}, 0)) : number * scales[kind - 4U];
    } else {
        return static_cast<Value>(std::is_same_v<Value, bool> ? data[0] & 1U : data[0]);
    }
}

/// Puts the value in `data` into one of the physical inputs: input number `which`, modulo the number of inputs.
template <typename Inputs>
void put_input(Inputs& inputs, unsigned which, const std::uint8_t* data) {
    unsigned count = 0;
    for_each_input(inputs, [&count](const char*, auto&) { ++count; });
    unsigned number = 0;
    for_each_input(inputs, [&](const char*, auto& input) {
        if (number++ == which % count) {
            input = value_of<std::decay_t<decltype(input)>>(data);
        }
    });
}

}  // namespace canproof::fuzz
