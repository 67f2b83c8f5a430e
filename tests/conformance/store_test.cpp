// Store and restore (CiA 301, 7.5.2.13, 7.5.2.14; CAN-CBX-AO412, 7.9.12, 7.9.13, 7.5.1), node 3.
#include <algorithm>
#include <array>

#include "generated/canopen/requirements.hpp"
#include "generated/cbx_ao412/requirements.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/faulty_memory.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Store : public CbxTest {
  protected:
    // 1017h (communication), 2404h:1 (manufacturer) and 6411h:1 (application): one value of each group.
    void set_values(const std::string& value) {
        write("603#2B171000" + value + "0000");
        write("603#2B042401" + value + "0000");
        write("603#2B116401" + value + "0000");
    }
    std::string values() {
        std::string all;
        for (const char* object : {"171000", "042401", "116401"}) {
            all += send(std::string{"603#40"} + object + "00000000").at(0).substr(12, 4) + " ";
        }
        return all;
    }
    /// A device on a memory of its own.
    Frames power_on_with(NonVolatileMemory& other) {
        queue = TransmitQueue{};
        device = std::make_unique<cbx_ao412::Device>(other, queue, factory);
        device->power_on(inputs, now);
        return sent();
    }
    std::string save() { return send("603#2310100173617665").at(0); }

    // Of the header, little-endian numbers.
    static constexpr std::size_t magic_at = 0;
    static constexpr std::size_t layout_at = 4;
    static constexpr std::size_t sequence_at = 8;

    static constexpr const char* saved = "583#6010100100000000";
    static constexpr const char* hardware_error = "583#8010100100000606";

    /// Where the second bank begins, which is the size of one: each begins with "COP" and its marker.
    std::size_t bank_size() {
        const std::array<std::uint8_t, 3> magic{'C', 'O', 'P'};
        const auto& bytes = memory.bytes();
        return static_cast<std::size_t>(std::search(bytes.begin() + 4, bytes.end(), magic.begin(), magic.end()) -
                                        bytes.begin());
    }
    /// Commits the bank of `size` bytes at `at` with another number in its header and the CRC-32 that goes with it.
    void set_header(std::size_t at, std::size_t size, std::size_t offset, std::uint32_t number) {
        memory.bytes()[at + 3] = 'S';
        put(at + offset, number);
        std::uint32_t crc = 0xFFFFFFFF;
        for (std::size_t i = at; i < at + size - 4; ++i) {
            crc ^= memory.bytes()[i];
            for (int bit = 0; bit < 8; ++bit) {
                crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
            }
        }
        put(at + size - 4, ~crc);
    }

  private:
    void put(std::size_t at, std::uint32_t number) {
        for (std::size_t i = 0; i < 4; ++i) {
            memory.bytes()[at + i] = static_cast<std::uint8_t>(number >> (8 * i));
        }
    }
};

}  // namespace

TEST_F(Store, SaveAllKeepsEachGroup) {
    verifies<req::CO_STORE_001, req::CO_K_STORE_SIGNATURE, req::AO4_OD_1010>();
    set_values("3412");
    EXPECT_EQ(send("603#2310100173617665"), (Frames{"583#6010100100000000"}));
    power_on();
    EXPECT_EQ(values(), "3412 3412 3412 ");
}

TEST_F(Store, WithoutSaveNothingIsKept) {
    verifies<req::CO_STORE_001>();
    set_values("3412");
    power_on();
    EXPECT_EQ(values(), "0000 0000 0000 ");
}

TEST_F(Store, EachSubIndexSavesItsGroupAndLeavesTheOthersAsStored) {
    verifies<req::CO_STORE_001>();
    const std::vector<std::pair<const char*, const char*>> groups{
        {"02", "2222 1111 1111 "}, {"03", "1111 1111 2222 "}, {"04", "1111 2222 1111 "}};
    for (const auto& [sub, expected] : groups) {
        set_values("1111");
        write("603#2310100173617665");
        set_values("2222");
        write(std::string{"603#231010"} + sub + "73617665");
        power_on();
        EXPECT_EQ(values(), expected) << sub;
    }
}

TEST_F(Store, OnlyTheRightWordIsObeyed) {
    verifies<req::CO_STORE_002>();
    set_values("3412");
    for (const char* word : {"65766173", "73617664", "00000000", "6C6F6164", "01000000"}) {
        EXPECT_EQ(send(std::string{"603#23101001"} + word), (Frames{"583#8010100120000008"})) << word;
    }
    EXPECT_EQ(send("603#2311100173617665"), (Frames{"583#8011100120000008"}));
    power_on();
    EXPECT_EQ(values(), "0000 0000 0000 ");
}

TEST_F(Store, LoadTakesEffectAtTheNextReset) {
    verifies<req::CO_STORE_003, req::CO_K_RESTORE_SIGNATURE, req::AO4_OD_1011>();
    set_values("3412");
    write("603#2310100173617665");
    EXPECT_EQ(send("603#231110016C6F6164"), (Frames{"583#6011100100000000"}));
    EXPECT_EQ(values(), "3412 3412 3412 ");
    send("000#8103");
    EXPECT_EQ(values(), "0000 0000 0000 ");
}

TEST_F(Store, LoadOfOneGroupLeavesTheOthersStored) {
    verifies<req::CO_STORE_003>();
    const std::vector<std::pair<const char*, const char*>> groups{
        {"02", "0000 3412 3412 "}, {"03", "3412 3412 0000 "}, {"04", "3412 0000 3412 "}};
    for (const auto& [sub, expected] : groups) {
        set_values("3412");
        write("603#2310100173617665");
        write(std::string{"603#231110"} + sub + "6C6F6164");
        power_on();
        EXPECT_EQ(values(), expected) << sub;
    }
}

TEST_F(Store, APowerCutAtAnyByteLeavesTheOldSetOrTheNew) {
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
              size_of_save - 1);  // the last byte but one commits the new set, the last makes the old one void
}

TEST_F(Store, AFailingMemoryIsToldAndLosesNothing) {
    verifies<req::CO_STORE_005>();
    set_values("1111");
    write("603#2310100173617665");
    set_values("2222");
    memory.cut_power_after(10);
    EXPECT_EQ(send("603#2310100173617665"), (Frames{"583#8010100100000606"}));
    memory.restore_power();
    power_on();
    EXPECT_EQ(values(), "1111 1111 1111 ");
}

TEST_F(Store, SavingIsForPreOperational) {
    verifies<req::AO4_STORE_001>();
    set_values("3412");
    send("000#0103");
    EXPECT_EQ(send("603#2310100173617665"), (Frames{"583#8010100122000008"}));
    EXPECT_EQ(send("603#231110016C6F6164"), (Frames{"583#6011100100000000"}));  // defaults may be asked for
    power_on();
    EXPECT_EQ(values(), "0000 0000 0000 ");
}

TEST_F(Store, ReadingTellsOnCommandNotByItself) {
    verifies<req::AO4_STORE_002, req::AO4_OD_1010, req::AO4_OD_1011>();
    for (const char* object : {"101001", "101002", "101003", "101004", "111001", "111002", "111003", "111004"}) {
        EXPECT_EQ(send(std::string{"603#40"} + object + "00000000").at(0), std::string{"583#43"} + object + "01000000");
    }
}

TEST_F(Store, WhatIsWritableIsStored) {
    verifies<req::AO4_STORE_003>();
    // object, length specifier, a value that it takes and that is not its default
    struct Case {
        const char* object;
        const char* specifier;
        const char* value;
    };
    const std::vector<Case> cases{{"051000", "23", "81000000"},
                                  {"061000", "23", "40420F00"},
                                  {"0C1000", "2B", "64000000"},
                                  {"0D1000", "2F", "03000000"},
                                  {"0E1000", "23", "13070000"},
                                  {"141000", "23", "83000080"},
                                  {"151000", "2B", "0A000000"},
                                  {"161001", "23", "E8033100"},
                                  {"171000", "2B", "D0070000"},
                                  {"291001", "2F", "02000000"},
                                  {"801F00", "23", "08000000"},
                                  {"911F01", "2B", "F4010000"},
                                  {"011401", "23", "03030080"},
                                  {"011402", "2F", "01000000"},
                                  {"021401", "23", "03040080"},
                                  {"021402", "2F", "FE000000"},
                                  {"116401", "2B", "01000000"},
                                  {"116404", "2B", "04000000"},
                                  {"436401", "2F", "02000000"},
                                  {"436404", "2F", "00000000"},
                                  {"446401", "23", "00000140"},
                                  {"446404", "23", "00000240"},
                                  {"042401", "2B", "05000000"},
                                  {"042404", "2B", "06000000"},
                                  {"052401", "2B", "07000000"},
                                  {"052404", "2B", "08000000"},
                                  // last, for a change of other configuration sets 1020h to zero
                                  {"201001", "23", "11223344"},
                                  {"201002", "23", "55667700"}};
    for (const auto& one : cases) {
        write(std::string{"603#"} + one.specifier + one.object + one.value);
    }
    write("603#2310100173617665");
    queue = TransmitQueue{};
    device = std::make_unique<cbx_ao412::Device>(memory, queue, factory);
    device->power_on(inputs, now);
    sent();
    for (const auto& one : cases) {
        const std::string answer = send(std::string{"603#40"} + one.object + "00000000").at(0);
        EXPECT_EQ(answer.substr(6), std::string{one.object} + one.value);
    }
}

TEST_F(Store, CobIdsThatWereSetAndStoredOutliveTheSwitches) {
    verifies<req::AO4_STORE_004, req::CO_PDO_035>();
    write("603#2314100083000080");  // 1014h = 93h
    write("603#2314100093000000");
    write("603#2310100273617665");
    inputs.switch_low = 5;
    EXPECT_EQ(power_on(), (Frames{"705#00"}));  // 100Eh was stored as it stood: it follows
    const auto cob_id = [&] { return send("605#4014100000000000").at(0).substr(12); };
    EXPECT_EQ(cob_id(), "93000000");
    EXPECT_EQ(send("605#4001140100000000"), Frames{"585#4301140105030000"});  // 1401h:1, RPDO2: 300h + 5
    EXPECT_EQ(send("605#231110026C6F6164"), (Frames{"585#6011100200000000"}));
    EXPECT_EQ(send("000#8105"), (Frames{"705#00"}));
    EXPECT_EQ(cob_id(), "85000000");
}

TEST_F(Store, CobIdsThatWereNotStoredFollowTheSwitches) {
    verifies<req::AO4_STORE_004>();
    write("603#2310100373617665");  // application only
    inputs.switch_low = 5;
    EXPECT_EQ(power_on(), (Frames{"705#00"}));
}

TEST_F(Store, TheSaveAfterTheLastSequenceNumberCounts) {
    verifies<req::CO_STORE_004>();
    write("603#2310100173617665");
    write("603#2310100173617665");
    // As after 2^32 - 1 saves: sequence numbers FFFFFFFEh and FFFFFFFFh.
    const std::size_t size = bank_size();
    set_header(0, size, sequence_at, 0xFFFFFFFE);
    set_header(size, size, sequence_at, 0xFFFFFFFF);
    EXPECT_EQ(power_on(), (Frames{"703#00"}));
    set_values("3412");
    // Power fails before the last byte, which would make the older set void: both are committed.
    memory.cut_power_after(size + 2);  // one byte makes the bank void, `size` fill it, one commits it
    EXPECT_EQ(save(), saved);
    memory.restore_power();
    power_on();
    EXPECT_EQ(values(), "3412 3412 3412 ");
}

TEST_F(Store, ACorruptSetGivesDefaultsAndTellsIt) {
    verifies<req::AO4_STORE_005, req::AO4_ERR_009>();
    set_values("3412");
    write("603#2310100173617665");
    memory.bytes()[40] ^= 0x01;
    EXPECT_EQ(power_on(), (Frames{"703#00", "083#1061010200000000"}));
    EXPECT_EQ(values(), "0000 0000 0000 ");
    EXPECT_EQ(send("603#4003100100000000"), (Frames{"583#4303100110610000"}));
    EXPECT_EQ(send("603#4003100200000000"), (Frames{"583#4303100200600000"}));
}

TEST_F(Store, ASetOfAnotherKindOrOfAnotherDictionaryIsCorrupt) {
    verifies<req::AO4_STORE_005>();
    set_values("3412");
    write("603#2310100173617665");
    write("603#2310100173617665");
    const std::size_t size = bank_size();
    const auto stored = memory.bytes();
    for (const std::size_t offset : {magic_at, layout_at}) {
        memory.bytes() = stored;
        set_header(0, size, offset, 0x12345678);
        set_header(size, size, offset, 0x12345678);
        EXPECT_EQ(power_on(), (Frames{"703#00", "083#1061010200000000"})) << offset;
        EXPECT_EQ(values(), "0000 0000 0000 ") << offset;
    }
}

TEST_F(Store, AnErasedMemoryHoldsNoSetAndADamagedHeaderACorruptOne) {
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

TEST_F(Store, AMemoryThatKeepsNothingIsFoundOut) {
    verifies<req::CO_STORE_005>();
    FaultyMemory worn{1024};
    worn.worn = true;
    power_on_with(worn);
    EXPECT_EQ(save(), hardware_error);
}

TEST_F(Store, SaveThatTheMemoryDoesNotCommitIsRefused) {
    verifies<req::CO_STORE_010, req::CO_STORE_005>();
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
    verifies<req::CO_STORE_010, req::CO_STORE_005>();
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

TEST_F(Store, AMemoryThatIsTooSmallIsToldWhenItIsUsed) {
    verifies<req::CO_STORE_005>();
    host::Memory small{64};
    EXPECT_EQ(power_on_with(small), (Frames{"703#00", "083#1061010200000000"}));
    EXPECT_EQ(save(), hardware_error);
    EXPECT_EQ(values(), "0000 0000 0000 ");
}

TEST_F(Store, AReadThatFailsAnywhereGivesTheStoredSetOrTheDefaultsAndIsNeverTakenForASave) {
    verifies<req::CO_STORE_004, req::CO_STORE_005>();
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
    write("603#2310100273617665");  // communication parameters anew, the others copied from the old bank
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
