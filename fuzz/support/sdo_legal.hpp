// SPDX-License-Identifier: Apache-2.0
// Checks which answers a server without block transfer may give to a request (CiA 301, 7.2.4.3). The check covers
// single frames and keeps no state, for targets in which SDO is one service among others. sdo_server_fuzz.cpp checks
// the whole protocol.
#pragma once

#include <algorithm>
#include <array>

#include "firmware/canopen/frame.hpp"

namespace canproof::fuzz {

/// Returns whether the code is in CiA 301, Table 22.
inline bool is_abort_code(std::uint32_t code) {
    constexpr std::array<std::uint32_t, 31> codes{
        0x05030000, 0x05040000, 0x05040001, 0x05040002, 0x05040003, 0x05040004, 0x05040005, 0x06010000,
        0x06010001, 0x06010002, 0x06020000, 0x06040041, 0x06040042, 0x06040043, 0x06040047, 0x06060000,
        0x06070010, 0x06070012, 0x06070013, 0x06090011, 0x06090030, 0x06090031, 0x06090032, 0x06090036,
        0x060A0023, 0x08000000, 0x08000020, 0x08000021, 0x08000022, 0x08000023, 0x08000024};
    return std::find(codes.begin(), codes.end(), code) != codes.end();
}

inline bool is_abort(const Frame& answer) {
    return answer.length == 8 && answer.data[0] == 0x80 && is_abort_code(read_u32(answer.payload(), 4));
}

namespace sdo_detail {

inline bool names_the_same(const Frame& request, const Frame& answer) {
    return std::equal(request.data.begin() + 1, request.data.begin() + 4, answer.data.begin() + 1);
}

/// Returns whether the last `count` bytes are zero.
inline bool is_clear(const Frame& answer, unsigned count) {
    return std::all_of(answer.data.end() - count, answer.data.end(), [](std::uint8_t byte) { return byte == 0; });
}

inline bool is_upload_answer(const Frame& request, const Frame& answer) {
    const unsigned command = answer.data[0];
    const unsigned unused = (command >> 2U) & 3U;
    const bool expedited = (command & 0xF3U) == 0x43U && is_clear(answer, unused);
    return names_the_same(request, answer) && (expedited || command == 0x41U);
}

inline bool is_upload_segment(const Frame& request, const Frame& answer) {
    const unsigned command = answer.data[0];
    return (command & 0xE0U) == 0U && ((command ^ request.data[0]) & 0x10U) == 0U &&
           is_clear(answer, (command >> 1U) & 7U);
}

}  // namespace sdo_detail

/// Returns whether `answer` is legal as the immediate answer to `request`. Both must have 8 bytes.
inline bool is_legal_answer(const Frame& request, const Frame& answer) {
    using namespace sdo_detail;
    if (request.length != 8 || answer.length != 8) {
        return false;
    }
    const unsigned asked = request.data[0] >> 5U;
    const bool initiates = asked == 1U || asked == 2U;
    if (answer.data[0] == 0x80) {
        return asked != 4U && is_abort(answer) && (!initiates || names_the_same(request, answer));
    }
    switch (asked) {
        case 0:
            return answer.data[0] == (0x20U | (request.data[0] & 0x10U)) && is_clear(answer, 7);
        case 1:
            return answer.data[0] == 0x60 && names_the_same(request, answer) && is_clear(answer, 4);
        case 2:
            return is_upload_answer(request, answer);
        case 3:
            return is_upload_segment(request, answer);
        default:
            return false;
    }
}

}  // namespace canproof::fuzz
