// SPDX-License-Identifier: Apache-2.0
// Tests the self-test of the settings: which changes of memory it notices, and which it permits.
#include "target/stm32f405/selftest/settings_guard.hpp"

#include <gtest/gtest.h>

#include "generated/canopen/requirements.hpp"
#include "tests/support/settings_watch.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// Settings of a node with two RPDOs, one TPDO and 16 bytes in its dictionary.
struct SettingsMemory {
    alignas(std::uint32_t) std::array<std::uint8_t, 16> values{};
    std::array<ReceivePdo, 2> received{};
    std::array<TransmitPdo, 1> sent{};
    std::array<PdoLine, 4> received_lines{};
    std::array<PdoLine, 2> sent_lines{};

    NodeSettings settings(std::uint32_t changes) {
        return {changes,
                ByteView{values},
                Slots<ReceivePdo>{received},
                Slots<TransmitPdo>{sent},
                Slots<PdoLine>{received_lines},
                Slots<PdoLine>{sent_lines}};
    }
};

}  // namespace

TEST(SettingsGuard, GuardNoticesEachFlippedBitOfEachSetting) {
    verifies<req::CO_SELF_019>();
    SettingsMemory memory;
    const NodeSettings settings = memory.settings(7);
    stm32f405::SettingsGuard guard;
    guard.keep(settings);
    std::size_t flipped = 0;
    for (MutableBytes& piece : pieces_of(settings)) {
        for (std::size_t bit = 0; bit < 8 * piece.size(); ++bit, ++flipped) {
            const auto turn = [&piece, bit] {
                piece.set(bit / 8, static_cast<std::uint8_t>(piece[bit / 8] ^ (1U << (bit % 8))));
            };
            turn();
            EXPECT_FALSE(guard.follow(settings)) << bit;
            turn();
            guard.keep(settings);
            EXPECT_TRUE(guard.follow(settings));
        }
    }
    EXPECT_EQ(flipped, 8 * (16 + 2 * sizeof(ReceivePdoSettings) + sizeof(TransmitPdoSettings) + 6 * sizeof(PdoLine)));
}

TEST(SettingsGuard, GuardPermitsACountedChangeOnce) {
    verifies<req::CO_SELF_019>();
    SettingsMemory memory;
    stm32f405::SettingsGuard guard;
    guard.keep(memory.settings(7));
    memory.values[5] = 1;
    EXPECT_TRUE(guard.follow(memory.settings(8)));
    EXPECT_TRUE(guard.follow(memory.settings(8)));
    memory.values[5] = 2;
    EXPECT_FALSE(guard.follow(memory.settings(8)));
}

TEST(SettingsGuard, GuardPermitsEveryChangeOfThePdosStates) {
    verifies<req::CO_SELF_019>();
    SettingsMemory memory;
    stm32f405::SettingsGuard guard;
    guard.keep(memory.settings(7));
    for (ReceivePdo& pdo : memory.received) {
        pdo.due = Instant{5};
        pdo.waiting = data_frame(0x201, 8, UINT64_MAX);
        pdo.waits = true;
    }
    memory.sent[0].sample = UINT64_MAX;
    memory.sent[0].watched = UINT64_MAX;
    memory.sent[0].sampled = true;
    memory.sent[0].pending = true;
    memory.sent[0].cycle_begun = true;
    memory.sent[0].syncs = 255;
    memory.sent[0].inhibited_until = Instant{6};
    memory.sent[0].timer_expires = Instant{7};
    memory.sent[0].due = Instant{8};
    EXPECT_TRUE(guard.follow(memory.settings(7)));
}

}  // namespace canproof::test
