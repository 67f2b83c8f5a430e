// SPDX-License-Identifier: Apache-2.0
#include "firmware/base/commit_marker.hpp"

namespace canproof {

namespace {

bool is_blank(const ByteView bytes) noexcept {
    bool same{true};
    for (std::size_t i = 1U; i < bytes.size(); ++i) {
        same = same && (std::uint32_t{bytes[i]} == bytes[0]);
    }
    return same && ((bytes[0] == 0xFFU) || (bytes[0] == 0x00U));
}

}  // namespace

BankState state_by_marker(const bool is_readable, const ByteView bytes, const std::uint8_t committed_marker) noexcept {
    const std::uint32_t marker = bytes[commit_marker_at];
    if (!is_readable) {
        return BankState::doubtful;
    }
    if ((marker == void_marker) || is_blank(bytes)) {
        return BankState::unused;
    }
    return (marker == committed_marker) ? BankState::damaged : BankState::doubtful;
}

}  // namespace canproof
