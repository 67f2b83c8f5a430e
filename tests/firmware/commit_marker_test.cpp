// SPDX-License-Identifier: Apache-2.0
// Tests the meaning of the first bytes (the marker) of a bank of stored values (firmware/base/commit_marker.hpp).
#include "firmware/base/commit_marker.hpp"

#include <gtest/gtest.h>

#include <array>

#include "generated/canopen/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

constexpr std::uint8_t committed = 0x53U;

BankState state_of(const std::array<std::uint8_t, 6>& bytes) {
    return state_by_marker(true, ByteView{bytes}, committed);
}

}  // namespace

// In erased memory, every byte reads as 00h, or every byte reads as FFh.
TEST(CommitMarker, OnlyAMemoryBankOfAllZerosOrAllFFhIsBlank) {
    verifies<req::CO_STORE_006>();
    for (const std::uint8_t blank : {std::uint8_t{0x00}, std::uint8_t{0xFF}}) {
        std::array<std::uint8_t, 6> bytes{};
        bytes.fill(blank);
        EXPECT_EQ(state_of(bytes), BankState::unused) << int{blank};
        for (std::size_t at = 0; at < bytes.size(); ++at) {
            for (const std::uint32_t changed : {0xA5U, 0xFFU}) {
                std::array<std::uint8_t, 6> written = bytes;
                written.at(at) = static_cast<std::uint8_t>(blank ^ changed);
                EXPECT_EQ(state_of(written), BankState::doubtful) << int{blank} << ", byte " << at;
            }
        }
    }
    std::array<std::uint8_t, 6> same{};
    same.fill(0x55);
    EXPECT_EQ(state_of(same), BankState::doubtful) << "55h is not erased memory";
}

TEST(CommitMarker, MarkerDistinguishesACommittedMemoryBankFromAnInvalidatedOne) {
    verifies<req::CO_STORE_006, req::CO_STORE_017>();
    EXPECT_EQ(state_of({0x43, 0x4F, 0x50, committed, 0x01, 0x02}), BankState::damaged);
    EXPECT_EQ(state_of({0x43, 0x4F, 0x50, void_marker, 0x01, 0x02}), BankState::unused);
    EXPECT_EQ(state_of({0x43, 0x4F, 0x50, 0x52, 0x01, 0x02}), BankState::doubtful);
    const std::array<std::uint8_t, 6> blank{};
    EXPECT_EQ(state_by_marker(false, ByteView{blank}, committed), BankState::doubtful) << "cannot be read";
}

}  // namespace canproof::test
