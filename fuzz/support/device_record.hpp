// What the bytes of a record mean in the world of a device, without the device: see device_world.hpp.
#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "firmware/base/bytes.hpp"
#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"

namespace canproof::fuzz {

constexpr std::size_t device_record_size = 12;

/// A data frame of the length in the low four bits of `how`, at most eight bytes.
inline Frame frame_of(std::uint32_t id, unsigned how, const std::uint8_t* data) {
    Frame frame = data_frame(id, static_cast<std::uint8_t>(std::min(how & 0x0FU, 8U)));
    std::copy_n(data, frame.length, frame.data.begin());
    return frame;
}

/// A frame of any identifier; bit 7 of `how` makes it a remote frame, bit 6 one of 29 bits.
inline Frame any_frame(unsigned how, const std::uint8_t* data) {
    Frame frame = frame_of((data[0] + 256U * data[1]) & 0x7FFU, how, data + 2);
    frame.remote = (how & 0x80U) != 0;
    frame.extended = (how & 0x40U) != 0;
    return frame;
}

/// The duration in a record of kind C: up to 10 s.
inline Duration duration_in(const std::uint8_t* record) {
    return milliseconds((record[2] + 256U * record[3]) % 10000U);
}

/// What a physical input of that type is set to; numbers are any bits or of a plain scale.
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

}  // namespace canproof::fuzz
