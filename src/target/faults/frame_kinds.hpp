// SPDX-License-Identifier: Apache-2.0
// The kinds of CAN frames. The fault-injection campaign uses the kind of a wrong or missing frame to judge the effect
// of a fault.
#pragma once

#include "firmware/canopen/frame.hpp"

namespace canproof::faults {

inline bool same_frame(const Frame& a, const Frame& b) {
    bool same = a.id == b.id && a.length == b.length && a.remote == b.remote;
    for (std::size_t i = 0; i < max_frame_length; ++i) {
        same = same && (i >= a.length || a.data[i] == b.data[i]);
    }
    return same;
}

inline std::uint32_t function_of(const Frame& frame) {
    return frame.id & 0x780U;
}
inline bool is_emcy(const Frame& frame) {
    return function_of(frame) == 0x080U && frame.id != 0x080U;
}
inline bool is_error_control(const Frame& frame) {
    return function_of(frame) == 0x700U;
}
inline bool is_pdo(const Frame& frame) {
    return function_of(frame) >= 0x180U && function_of(frame) < 0x580U && (frame.id & 0x80U) != 0U;
}

}  // namespace canproof::faults
