// SPDX-License-Identifier: Apache-2.0
// The commit marker: the byte of a bank of stored values that distinguishes a completely written bank from an
// interrupted save. It lets the firmware recognise a damaged bank and not mistake it for an interrupted save.
#pragma once

#include "firmware/base/bytes.hpp"

namespace canproof {

/// Position of the commit marker: the last letter of the magic word at the start of a bank. A bank with that letter is
/// committed.
constexpr std::size_t commit_marker_at = 3U;
/// Marker of a void bank: a save into it has begun, or a newer bank is valid. The contents of the bank are not used.
constexpr std::uint8_t void_marker = 0x2DU;

/// State of a bank. If the states of the two banks differ, the bank whose state has the greater value decides what is
/// loaded.
enum class BankState : std::uint8_t {
    unused,    ///< marked void, or blank (first bytes all 00h or all FFh)
    doubtful,  ///< unreadable, or without a known marker; counts as damage unless the other bank is sound
    sound,     ///< readable and of the present layout, and its CRC is right
    damaged    ///< committed, but not sound, for example because its contents have changed since the save
};

/// Returns what the first bytes of a bank show: unused, doubtful, or damaged. It never returns sound: the caller must
/// check whether a doubtful or damaged bank is in fact sound, that is, readable as a whole and with the present layout
/// and the right CRC.
BankState state_by_marker(bool is_readable, ByteView bytes, std::uint8_t committed_marker) noexcept;

}  // namespace canproof
