// SPDX-License-Identifier: Apache-2.0
// Tests the storing of parameters on a memory that fails, loses its power or has unexpected content (CiA 301, 7.5.2.13,
// 7.5.2.14) on node 3.
#include "generated/canopen/requirements.hpp"
#include "generated/cbx_ao412/requirements.hpp"
#include "tests/conformance/store_cases.hpp"
#include "tests/support/faulty_memory.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

TEST_F(Store, PowerCutAtAnyByteLeavesTheOldOrTheNewParameterSet) {
    verifies<req::CO_STORE_004>();
    set_values("1111");
    write("603#2310100173617665");
    const auto stored = memory.bytes();
    const std::size_t before = memory.written();
    set_values("2222");
    write("603#2310100173617665");
    const std::size_t size_of_save = memory.written() - before;
    ASSERT_GT(size_of_save, 100U);
    std::size_t old_sets = 0;
    for (std::size_t cut = 0; cut <= size_of_save; ++cut) {
        memory.bytes() = stored;
        power_on();
        set_values("2222");
        memory.cut_power_after(cut);
        send("603#2310100173617665");
        memory.restore_power();
        power_on();
        const std::string found = values();
        EXPECT_TRUE(found == "1111 1111 1111 " || found == "2222 2222 2222 ")
            << "cut after " << cut << " bytes: " << found;
        old_sets += found == "1111 1111 1111 " ? 1 : 0;
    }
    EXPECT_EQ(old_sets,
              size_of_save - 1);  // of the bytes of a save, the last but one commits the new set, and the last
                                  // invalidates the old set
}

/// The power fails after the last byte but one of a save, which commits the new set. Both sets are then committed; the
/// later one has the higher sequence number.
TEST_F(Store, LaterOfTwoCommittedParameterSetsIsLoaded) {
    verifies<req::CO_STORE_004>();
    set_values("0000");
    const std::size_t before = memory.written();
    EXPECT_EQ(save(), saved);
    const std::size_t size_of_save = memory.written() - before;
    for (const char* value : {"1111", "2222", "3312", "0422", "1512"}) {
        set_values(value);
        memory.cut_power_after(size_of_save - 1);
        EXPECT_EQ(save(), saved);
        memory.restore_power();
        power_on();
        const std::string once = std::string{value} + " ";
        EXPECT_EQ(values(), once + once + once);
    }
}

/// One bit of the marker has flipped. The CRC still shows that the set is complete.
TEST_F(Store, CommittedSetWithADamagedMarkerIsLoaded) {
    verifies<req::CO_STORE_004>();
    set_values("3412");
    EXPECT_EQ(save(), saved);
    memory.bytes()[3] ^= 0x04;
    EXPECT_EQ(power_on(), (Frames{"703#00"}));
    EXPECT_EQ(values(), "3412 3412 3412 ");
}

TEST_F(Store, DamagedStoredSetBesideAValidSetGivesDefaultsWhicheverIsLater) {
    verifies<req::AO4_STORE_005, req::AO4_ERR_009, req::AO4_ERR_023>();
    for (const std::size_t damaged : {std::size_t{0}, std::size_t{1}}) {
        std::fill(memory.bytes().begin(), memory.bytes().end(), std::uint8_t{0xFF});
        power_on();
        set_values("3412");
        EXPECT_EQ(save(), saved);
        EXPECT_EQ(save(), saved);  // the second save has made the set of the first save invalid
        const std::size_t size = bank_size();
        memory.bytes()[3] = memory.bytes()[size + 3];
        memory.bytes()[damaged * size + 40] ^= 0x01;
        EXPECT_EQ(power_on(), (Frames{"703#00", "083#1061010200000000"})) << damaged;
        EXPECT_EQ(values(), "0000 0000 0000 ") << damaged;
    }
}

TEST_F(Store, SaveToAFailingMemoryIsReportedAndTheOldSetIsKept) {
    verifies<req::CO_STORE_005, req::CO_STORE_013>();
    set_values("1111");
    write("603#2310100173617665");
    set_values("2222");
    memory.cut_power_after(10);
    EXPECT_EQ(send("603#2310100173617665"), (Frames{"583#8010100100000606"}));
    memory.restore_power();
    power_on();
    EXPECT_EQ(values(), "1111 1111 1111 ");
}

TEST_F(Store, SetSavedAfterTheHighestSequenceNumberIsLoaded) {
    verifies<req::CO_STORE_004>();
    write("603#2310100173617665");
    write("603#2310100173617665");
    // The state after 2^32 - 1 saves: the two banks have the sequence numbers FFFFFFFEh and FFFFFFFFh.
    const std::size_t size = bank_size();
    set_header(0, size, sequence_at, 0xFFFFFFFE);
    set_header(size, size, sequence_at, 0xFFFFFFFF);
    EXPECT_EQ(power_on(), (Frames{"703#00"}));
    set_values("3412");
    // The power fails before the last byte of the save, which would invalidate the older set. So both sets are
    // committed.
    memory.cut_power_after(size + 2);  // of a save: one byte to invalidate the bank, `size` bytes to fill it, one byte
                                       // to commit it
    EXPECT_EQ(save(), saved);
    memory.restore_power();
    power_on();
    EXPECT_EQ(values(), "3412 3412 3412 ");
}

TEST_F(Store, CorruptStoredSetGivesDefaultsAndIsReported) {
    verifies<req::AO4_STORE_005, req::AO4_ERR_009, req::AO4_ERR_023>();
    set_values("3412");
    write("603#2310100173617665");
    memory.bytes()[40] ^= 0x01;
    EXPECT_EQ(power_on(), (Frames{"703#00", "083#1061010200000000"}));
    EXPECT_EQ(values(), "0000 0000 0000 ");
    EXPECT_EQ(send("603#4003100100000000"), (Frames{"583#4303100110610000"}));
    EXPECT_EQ(send("603#4003100200000000"), (Frames{"583#4303100200600000"}));
}

TEST_F(Store, StoredSetOfAnotherFormatOrDictionaryCountsAsCorrupt) {
    verifies<req::AO4_STORE_005, req::CO_STORE_019>();
    set_values("3412");
    write("603#2310100173617665");
    write("603#2310100173617665");
    const std::size_t size = bank_size();
    const auto stored = memory.bytes();
    for (const std::size_t offset : {magic_at, layout_at}) {
        memory.bytes() = stored;
        set_header(0, size, offset, 0x53345678);  // a wrong number; its highest byte 53h is the marker of a committed
                                                  // set
        set_header(size, size, offset, 0x53345678);
        EXPECT_EQ(power_on(), (Frames{"703#00", "083#1061010200000000"})) << offset;
        EXPECT_EQ(values(), "0000 0000 0000 ") << offset;
    }
}

TEST_F(Store, ErasedMemoryContainsNoStoredSetAndADamagedHeaderIsCorrupt) {
    verifies<req::AO4_STORE_005>();
    for (const std::uint8_t blank : {std::uint8_t{0xFF}, std::uint8_t{0x00}}) {
        std::fill(memory.bytes().begin(), memory.bytes().end(), blank);
        EXPECT_EQ(power_on(), (Frames{"703#00"})) << int{blank};
        for (const std::size_t at : {0U, 5U, 13U}) {
            std::fill(memory.bytes().begin(), memory.bytes().end(), blank);
            memory.bytes()[at] = 0x5A;
            EXPECT_EQ(power_on(), (Frames{"703#00", "083#1061010200000000"})) << int{blank} << ' ' << at;
        }
    }
}

TEST_F(Store, SaveToAMemoryThatDoesNotKeepWrittenBytesIsRefused) {
    verifies<req::CO_STORE_005>();
    FaultyMemory worn{1024};
    worn.worn = true;
    power_on_with(worn);
    EXPECT_EQ(save(), hardware_error);
}

TEST_F(Store, SaveThatTheMemoryDoesNotCommitIsRefused) {
    verifies<req::CO_STORE_014, req::CO_STORE_005, req::CO_STORE_013, req::CO_STORE_018>();
    FaultyMemory faulty{1024};
    power_on_with(faulty);
    set_values("1111");
    EXPECT_EQ(save(), saved);
    EXPECT_EQ(faulty.commits, 1U);
    set_values("2222");
    faulty.fail_commit(1);
    EXPECT_EQ(save(), hardware_error);
    power_on_with(faulty);
    EXPECT_EQ(values(), "1111 1111 1111 ");
}

TEST_F(Store, RestoreThatTheMemoryDoesNotCommitIsRefused) {
    verifies<req::CO_STORE_014, req::CO_STORE_005, req::CO_STORE_013, req::CO_STORE_018>();
    FaultyMemory faulty{1024};
    power_on_with(faulty);
    set_values("1111");
    EXPECT_EQ(save(), saved);
    faulty.fail_commit(1);
    EXPECT_EQ(send("603#231110016C6F6164"), (Frames{"583#8011100100000606"}));
    power_on_with(faulty);
    EXPECT_EQ(values(), "1111 1111 1111 ");
    faulty.fail_commit(0);
    EXPECT_EQ(send("603#231110016C6F6164"), (Frames{"583#6011100100000000"}));
    EXPECT_EQ(faulty.commits, 1U);
}

// The last write of a save makes the older set void; the newer of two committed sets is loaded. A failing write may
// have stored none or all of its bytes.
TEST_F(Store, SaveWithAFailedWriteIsRefusedAndKeepsTheSetStoredBefore) {
    verifies<req::CO_STORE_005, req::CO_STORE_013>();
    FaultyMemory faulty{1024};
    power_on_with(faulty);
    set_values("1111");
    faulty.fail_write(0);
    EXPECT_EQ(save(), saved);
    const std::size_t writes = faulty.writes;
    ASSERT_GT(writes, 10U);
    const auto sound = faulty.sound.bytes();
    for (const std::size_t stored : {std::size_t{0}, SIZE_MAX}) {
        for (std::size_t n = 1; n <= writes; ++n) {
            faulty.sound.bytes() = sound;
            power_on_with(faulty);
            set_values("2222");
            faulty.fail_write(n, stored);
            EXPECT_EQ(save(), n < writes ? hardware_error : saved) << n << ' ' << stored;
            EXPECT_EQ(power_on_with(faulty), (Frames{"703#00"})) << n << ' ' << stored;
            EXPECT_EQ(values(), n < writes ? "1111 1111 1111 " : "2222 2222 2222 ") << n << ' ' << stored;
        }
    }
}

// A damaged set has priority over a sound one. If it cannot be made void, the new set would not be loaded.
TEST_F(Store, SaveThatCannotVoidADamagedSetIsRefused) {
    verifies<req::CO_STORE_005, req::CO_STORE_010>();
    FaultyMemory faulty{1024};
    power_on_with(faulty);
    set_values("1111");
    faulty.fail_write(0);
    EXPECT_EQ(save(), saved);
    const std::size_t last = faulty.writes;
    faulty.sound.bytes()[40] ^= 0x01;
    const auto damaged = faulty.sound.bytes();
    for (const std::size_t stored : {std::size_t{0}, SIZE_MAX}) {
        faulty.sound.bytes() = damaged;
        EXPECT_EQ(power_on_with(faulty), (Frames{"703#00", "083#1061010200000000"}));
        set_values("2222");
        faulty.fail_write(last, stored);
        EXPECT_EQ(save(), hardware_error);
        power_on_with(faulty);
        EXPECT_EQ(values(), "0000 0000 0000 ");
        set_values("2222");
        EXPECT_EQ(save(), saved);
        power_on_with(faulty);
        EXPECT_EQ(values(), "2222 2222 2222 ");
    }
}

TEST_F(Store, MemoryThatIsTooSmallIsReportedAtPowerOnAndRefusesASave) {
    verifies<req::CO_STORE_005>();
    host::Memory small{64};
    EXPECT_EQ(power_on_with(small), (Frames{"703#00", "083#1061010200000000"}));
    EXPECT_EQ(save(), hardware_error);
    EXPECT_EQ(values(), "0000 0000 0000 ");
}

TEST_F(Store, FailedReadGivesDefaultsAndAnErrorAtPowerOnAndRefusesASave) {
    verifies<req::CO_STORE_004, req::CO_STORE_005, req::CO_STORE_013>();
    FaultyMemory faulty{1024};
    power_on_with(faulty);
    set_values("1111");
    EXPECT_EQ(save(), saved);
    faulty.fail_read(0);
    power_on_with(faulty);
    const std::size_t reads = faulty.reads;
    ASSERT_GT(reads, 10U);
    for (std::size_t n = 1; n <= reads; ++n) {
        faulty.fail_read(n);
        power_on_with(faulty);
        faulty.fail_read(0);
        const std::string found = values();
        const bool told = send("603#4001100000000000").at(0).substr(12, 2) == "01";
        EXPECT_TRUE(told ? found == "0000 0000 0000 " : found == "1111 1111 1111 ") << n << ": " << found;
    }
    power_on_with(faulty);
    faulty.fail_read(0);
    write("603#2310100273617665");  // saves the communication parameters and copies the other groups from the old bank
    const std::size_t of_save = faulty.reads;
    const auto sound = faulty.sound.bytes();
    for (std::size_t n = 1; n <= of_save; ++n) {
        faulty.sound.bytes() = sound;
        power_on_with(faulty);
        faulty.fail_read(n);
        EXPECT_EQ(send("603#2310100273617665"), (Frames{"583#8010100200000606"})) << n;
        faulty.fail_read(0);
        power_on_with(faulty);
        EXPECT_EQ(values(), "1111 1111 1111 ") << n;
    }
}

}  // namespace canproof::test
