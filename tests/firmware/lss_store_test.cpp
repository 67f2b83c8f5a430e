// SPDX-License-Identifier: Apache-2.0
// Tests how LSS stores node-ID and bit rate in the non-volatile memory (CiA 305, 6.4.5).
#include "firmware/canopen/lss_store.hpp"

#include <gtest/gtest.h>

#include "firmware/base/crc32.hpp"
#include "generated/canopen/requirements.hpp"
#include "host/sim/devices/memory.hpp"
#include "tests/support/faulty_memory.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

constexpr LssConfiguration shipped{127, 125000};

void expect(const LssConfiguration& found, int node_id, std::uint32_t bit_rate) {
    EXPECT_EQ(found.node_id, node_id);
    EXPECT_EQ(found.bit_rate, bit_rate);
}

}  // namespace

TEST(LssStore, FactoryValuesApplyWhenNothingIsStored) {
    verifies<req::CO_LSS_017>();
    host::Memory memory{64};
    expect(LssStore{memory}.load(shipped), 127, 125000);
}

TEST(LssStore, LatestStoredConfigurationIsLoaded) {
    verifies<req::CO_LSS_016, req::CO_LSS_017>();
    host::Memory memory{64};
    for (int node_id = 1; node_id < 6; ++node_id) {
        EXPECT_EQ(LssStore{memory}.store({static_cast<std::uint8_t>(node_id), 250000}), LssError::none);
        expect(LssStore{memory}.load(shipped), node_id, 250000);
    }
}

TEST(LssStore, LssStoreWorksInAMemoryOfExactlyItsSize) {
    verifies<req::CO_LSS_016, req::CO_LSS_017>();
    host::Memory memory{LssStore::size};
    for (int node_id = 1; node_id < 4; ++node_id) {
        EXPECT_EQ(LssStore{memory}.store({static_cast<std::uint8_t>(node_id), 250000}), LssError::none);
        expect(LssStore{memory}.load(shipped), node_id, 250000);
    }
}

TEST(LssStore, StoreWritesOnlyTheLast40BytesOfTheMemory) {
    verifies<req::CO_LSS_016>();
    host::Memory memory{64};
    LssStore{memory}.store({5, 500000});
    for (std::size_t at = 0; at < 64 - 40; ++at) {
        EXPECT_EQ(memory.bytes()[at], 0xFF) << at;
    }
}

TEST(LssStore, PowerCutAtAnyByteLeavesTheOldOrTheNewConfiguration) {
    verifies<req::CO_LSS_016>();
    // A save writes 23 bytes: 1 makes the slot invalid, 20 fill it, 1 makes it valid, and 1 makes the other slot
    // invalid.
    for (std::size_t cut = 0; cut <= 23; ++cut) {
        host::Memory memory{64};
        LssStore{memory}.store({1, 10000});
        LssStore{memory}.store({2, 20000});
        memory.cut_power_after(cut);
        const LssError answer = LssStore{memory}.store({3, 50000});
        memory.restore_power();
        EXPECT_EQ(answer, cut < 22 ? LssError::storage_failed : LssError::none);
        const LssConfiguration found = LssStore{memory}.load(shipped);
        EXPECT_EQ(found.node_id, cut < 22 ? 2 : 3) << cut;
        EXPECT_EQ(found.bit_rate, cut < 22 ? 20000U : 50000U) << cut;
        EXPECT_FALSE(found.damaged) << cut;
        EXPECT_EQ(LssStore{memory}.store({4, 100000}), LssError::none);
        EXPECT_EQ(LssStore{memory}.load(shipped).node_id, 4) << cut;
    }
}

TEST(LssStore, PowerCutAfterTenBytesKeepsTheConfigurationOfTheSlotInUse) {
    verifies<req::CO_LSS_016>();
    for (const int before : {1, 2, 3, 4}) {
        host::Memory memory{64};
        for (int node_id = 1; node_id <= before; ++node_id) {
            LssStore{memory}.store({static_cast<std::uint8_t>(node_id), 10000});
        }
        memory.cut_power_after(10);
        LssStore{memory}.store({100, 50000});
        memory.restore_power();
        expect(LssStore{memory}.load(shipped), before, 10000);
    }
}

TEST(LssStore, SlotWithAWrongMarkerIsIgnored) {
    verifies<req::CO_LSS_017>();
    host::Memory memory{64};
    LssStore{memory}.store({1, 10000});
    auto& bytes = memory.bytes();
    bytes[64 - 40] ^= 1;
    Crc32 crc{};  // the slot gets a valid CRC-32 again: its last four bytes, computed over its first 16
    crc.add(ByteView{bytes.data() + 64 - 40, 16});
    for (std::size_t i = 0; i < 4; ++i) {
        bytes[64 - 40 + 16 + i] = static_cast<std::uint8_t>(crc.value() >> (8 * i));
    }
    expect(LssStore{memory}.load(shipped), 127, 125000);
}

TEST(LssStore, DamageOfTheLatestSlotGivesTheFactoryValues) {
    verifies<req::CO_LSS_017, req::CO_LSS_065>();
    // the latest settings are in the first slot after one save, in the second after two, in the first after three
    for (const int stores : {1, 2, 3}) {
        for (std::size_t at = 0; at < 40; ++at) {
            host::Memory memory{64};
            for (int node_id = 1; node_id <= stores; ++node_id) {
                LssStore{memory}.store({static_cast<std::uint8_t>(node_id), 20000});
            }
            memory.bytes()[64 - 40 + at] ^= 0xFF;
            const std::size_t latest = stores == 2 ? 20 : 0;
            const bool hit =
                at >= latest && at < latest + 20 && at != latest + 3;  // a change of the marker byte has no effect
            const LssConfiguration found = LssStore{memory}.load(shipped);
            EXPECT_EQ(found.damaged, hit) << stores << ' ' << at;
            expect(found, found.damaged ? 127 : stores, found.damaged ? 125000 : 20000);
        }
    }
}

TEST(LssStore, DamageStaysReportedUntilASaveIsComplete) {
    verifies<req::CO_LSS_065, req::CO_LSS_016>();
    for (const int stores : {1, 2}) {
        for (std::size_t cut = 0; cut <= 23; ++cut) {
            host::Memory memory{64};
            for (int node_id = 1; node_id <= stores; ++node_id) {
                LssStore{memory}.store({static_cast<std::uint8_t>(node_id), 20000});
            }
            memory.bytes()[64 - 40 + (stores == 2 ? 20 : 0) + 12] ^= 1;  // the node-ID of the latest slot
            memory.cut_power_after(cut);
            LssStore{memory}.store({9, 50000});
            memory.restore_power();
            const LssConfiguration found = LssStore{memory}.load(shipped);
            // the configuration counts as damaged until a save invalidates the damaged slot
            EXPECT_EQ(found.damaged, cut < 23) << stores << ' ' << cut;
            expect(found, cut < 23 ? 127 : 9, cut < 23 ? 125000 : 50000);
            EXPECT_EQ(LssStore{memory}.store({10, 10000}), LssError::none);
            expect(LssStore{memory}.load(shipped), 10, 10000);
            EXPECT_FALSE(LssStore{memory}.load(shipped).damaged) << stores << ' ' << cut;
        }
    }
}

TEST(LssStore, FirstOfTwoSlotsWithEqualSequenceNumbersIsLoaded) {
    verifies<req::CO_LSS_017>();
    // This state arises only if one slot is copied over the other. Slots have 20 bytes each, at the end of the memory.
    host::Memory memory{64};
    LssStore{memory}.store({5, 500000});
    auto& bytes = memory.bytes();
    const std::vector<std::uint8_t> slot(bytes.end() - 40, bytes.end() - 20);
    std::copy(slot.begin(), slot.end(), bytes.end() - 20);
    expect(LssStore{memory}.load(shipped), 5, 500000);
    EXPECT_EQ(LssStore{memory}.store({6, 250000}), LssError::none);
    expect(LssStore{memory}.load(shipped), 6, 250000);
}

// Slots have 20 bytes each, at the end of the memory: byte 3 of a slot is the marker, bytes 4 to 7 are the sequence
// number.
TEST(LssStore, NewSlotIsLoadedWhenTheOlderSlotIsStillMarkedCommitted) {
    verifies<req::CO_LSS_017>();
    for (int stores = 1; stores <= 6; ++stores) {
        host::Memory memory{64};
        auto& bytes = memory.bytes();
        for (int node_id = 1; node_id <= stores; ++node_id) {
            ASSERT_EQ(LssStore{memory}.store({static_cast<std::uint8_t>(node_id), 20000}), LssError::none);
        }
        const std::size_t older = stores % 2 == 1 ? 24 : 44;
        const std::size_t other = stores % 2 == 1 ? 44 : 24;
        const std::uint8_t committed = bytes.at(older + 3);
        std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(other) + 4, 4, std::uint8_t{0});
        ASSERT_EQ(LssStore{memory}.store({9, 50000}), LssError::none);
        bytes.at(older + 3) = committed;  // as if the last write of the save had failed
        expect(LssStore{memory}.load(shipped), 9, 50000);
    }
}

TEST(LssStore, MemoryThatIsTooSmallStoresNothing) {
    verifies<req::CO_LSS_076>();
    host::Memory memory{8};
    expect(LssStore{memory}.load(shipped), 127, 125000);
    EXPECT_EQ(LssStore{memory}.store({6, 250000}), LssError::storage_failed);
}

TEST(LssStore, ConfigurationThatTheMemoryDoesNotCommitIsRefused) {
    verifies<req::CO_LSS_076, req::CO_LSS_088>();
    FaultyMemory memory{64};
    EXPECT_EQ(LssStore{memory}.store({5, 500000}), LssError::none);
    EXPECT_EQ(memory.commits, 1U);
    memory.fail_commit(1);
    EXPECT_EQ(LssStore{memory}.store({6, 250000}), LssError::storage_failed);
    expect(LssStore{memory}.load(shipped), 5, 500000);
}

// A save makes three writes to a slot: marker `invalid`, the content, marker `valid`. A fourth write makes the older
// slot invalid. A failing write may have stored none, some or all of its bytes.
TEST(LssStore, FailedWriteOfASlotIsReportedAndKeepsTheSettingsStoredBefore) {
    verifies<req::CO_LSS_076, req::CO_LSS_088>();
    for (const int stores : {0, 1, 2}) {
        for (const std::size_t failing : {1U, 2U, 3U, 4U}) {
            for (const std::size_t stored : {0U, 1U, 10U, 20U}) {
                FaultyMemory memory{64};
                for (int node_id = 1; node_id <= stores; ++node_id) {
                    ASSERT_EQ(LssStore{memory}.store({static_cast<std::uint8_t>(node_id), 20000}), LssError::none);
                }
                memory.fail_write(failing, stored);
                const LssError answer = LssStore{memory}.store({6, 250000});
                EXPECT_EQ(answer, failing < 4 ? LssError::storage_failed : LssError::none) << failing;
                const LssConfiguration found = LssStore{memory}.load(shipped);
                EXPECT_FALSE(found.damaged) << stores << ' ' << failing << ' ' << stored;
                if (failing == 4) {
                    expect(found, 6, 250000);
                } else {
                    expect(found, stores == 0 ? 127 : stores, stores == 0 ? 125000 : 20000);
                }
            }
        }
    }
}

// A damaged slot has priority over a sound one. If it cannot be made invalid, the new settings would not be loaded.
TEST(LssStore, SaveThatCannotInvalidateADamagedSlotIsReportedAsFailed) {
    verifies<req::CO_LSS_076, req::CO_LSS_016>();
    for (const int stores : {1, 2}) {
        for (const std::size_t stored : {0U, 1U}) {
            FaultyMemory memory{64};
            for (int node_id = 1; node_id <= stores; ++node_id) {
                ASSERT_EQ(LssStore{memory}.store({static_cast<std::uint8_t>(node_id), 20000}), LssError::none);
            }
            memory.sound.bytes()[64 - 40 + (stores == 2 ? 20 : 0) + 12] ^= 1;  // the node-ID of the latest slot
            memory.fail_write(4, stored);
            EXPECT_EQ(LssStore{memory}.store({6, 250000}), LssError::storage_failed);
            expect(LssStore{memory}.load(shipped), 127, 125000);
            EXPECT_EQ(LssStore{memory}.store({6, 250000}), LssError::none);
            expect(LssStore{memory}.load(shipped), 6, 250000);
        }
    }
}

TEST(LssStore, FailedReadCountsAsNothingStored) {
    verifies<req::CO_LSS_017>();
    FaultyMemory memory{64};
    LssStore{memory}.store({5, 500000});
    memory.fail_read(1);
    const LssConfiguration unreadable = LssStore{memory}.load(shipped);
    expect(unreadable, 127, 125000);
    EXPECT_TRUE(unreadable.damaged);
    memory.fail_read(0);
    expect(LssStore{memory}.load(shipped), 5, 500000);
}

// CiA 305, 6.4.2: valid node-IDs are 1 to 127, and 255 for no node-ID
TEST(LssStore, ImpossibleStoredNodeIdCountsAsNothingStored) {
    verifies<req::CO_LSS_066, req::CO_K_LSS_LOWEST_NODE_ID, req::CO_K_LSS_HIGHEST_NODE_ID>();
    for (int node_id = 0; node_id <= 255; ++node_id) {
        host::Memory memory{64};
        LssStore{memory}.store({9, 500000});  // the other slot has older settings, which are not used either
        LssStore{memory}.store({static_cast<std::uint8_t>(node_id), 20000});
        const bool counts = (node_id >= 1 && node_id <= 127) || node_id == 255;
        const LssConfiguration found = LssStore{memory}.load(shipped);
        expect(found, counts ? node_id : 127, counts ? 20000 : 125000);
        EXPECT_FALSE(found.damaged) << node_id;
        EXPECT_EQ(LssStore{memory}.store({10, 10000}), LssError::none);
        expect(LssStore{memory}.load(shipped), 10, 10000);
    }
}

}  // namespace canproof::test
