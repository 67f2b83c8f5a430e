// The byte of a bank of stored values that tells a bank that was written to its end from one that was not. With it a
// damaged bank is no save that was cut short.
#pragma once

#include "firmware/base/bytes.hpp"

namespace canproof {

/// It is the last letter of the word with which a bank begins; that letter itself says that the bank counts.
constexpr std::size_t commit_marker_at = 3U;
/// A save into the bank has begun, or a newer bank holds: what it contains is of no account.
constexpr std::uint8_t void_marker = 0x2DU;

/// What a bank is found to be. Of two banks that with the greater value decides.
enum class BankState : std::uint8_t {
    unused,    ///< void, or as the memory was made or erased
    doubtful,  ///< not to be read, or no save wrote it: a damage where the other bank is not sound
    sound,     ///<
    damaged    ///< committed, and no longer what was written
};

/// What is known of a bank by its first bytes: unused, doubtful, or damaged as long as its CRC has not been found
/// right.
BankState state_by_marker(bool is_readable, ByteView bytes, std::uint8_t committed_marker) noexcept;

}  // namespace canproof
