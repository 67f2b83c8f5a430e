// SPDX-License-Identifier: Apache-2.0
// Tests storing and restoring of parameters on a small memory (CiA 301, 7.5.2.13), with faults in each byte of the
// memory and in each access to it. The slave, node 5, has one stored value, the 4 bytes of 2207h. A bank has a header
// of 16 bytes, the value and a CRC of 4 bytes, 24 bytes in total. There are two banks.
#include <algorithm>
#include <numeric>

#include "generated/canopen/requirements.hpp"
#include "tests/support/altered_slave.hpp"
#include "tests/support/faulty_memory.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class SmallStore : public testing::Test, public AlteredSlaveBench {
  protected:
    SmallStore() {
        for (EntryRow& row : description.rows.entries) {
            row.rights = static_cast<std::uint8_t>(row.rights & ~rights::stored);
        }
        keep(0x2207);
        memory.bytes().resize(2 * bank_size);
    }
    void keep(std::uint16_t index) {
        EntryRow& row = entry(index, 0);
        row.rights = static_cast<std::uint8_t>(row.rights | rights::stored);
    }
    Frames power_on_with(NonVolatileMemory& other, std::uint8_t node_id = 5) {
        queue = TransmitQueue{};
        device = std::make_unique<host::GenericDevice>(description, other, queue);
        return switch_on([this, node_id] { device->power_on(node_id, now); });
    }
    void set_value(const std::string& value) {
        EXPECT_EQ(send("605#23072200" + value), Frames{"585#6007220000000000"});
    }
    std::string value() { return send("605#4007220000000000").at(0).substr(12); }
    std::string save(const std::string& group = "01") { return send("605#231010" + group + "73617665").at(0); }

    static constexpr std::size_t bank_size = 24;
    static constexpr const char* saved = "585#6010100100000000";
    static constexpr const char* hardware_error = "585#8010100100000606";
    // error code 6300h, 1001h = 01h (generic error), one listed error
    static constexpr const char* corrupt = "085#0063010100000000";
};

}  // namespace

TEST_F(SmallStore, MemoryOfExactlyTwoBanksIsEnough) {
    verifies<req::CO_STORE_001>();
    EXPECT_EQ(power_on(), Frames{"705#00"});
    for (const char* number : {"11223344", "55667788", "99AABBCC"}) {
        set_value(number);
        EXPECT_EQ(save(), saved);
        EXPECT_EQ(power_on(), Frames{"705#00"});
        EXPECT_EQ(value(), number);
    }
}

TEST_F(SmallStore, SaveToAMemoryOneByteTooSmallIsRefusedBeforeAnyWrite) {
    verifies<req::CO_STORE_005>();
    memory.bytes().resize(2 * bank_size - 1);
    EXPECT_EQ(power_on(), Frames{"705#00"});
    EXPECT_EQ(save(), hardware_error);
    EXPECT_EQ(memory.written(), 0U);
}

TEST_F(SmallStore, BytesBehindTheTwoBanksAreIgnored) {
    verifies<req::CO_STORE_001>();
    memory.bytes().resize(3 * bank_size, 0x55);
    EXPECT_EQ(power_on(), Frames{"705#00"});
}

TEST_F(SmallStore, HeaderOfBytes55hIsCorruptAndNotBlank) {
    verifies<req::CO_STORE_013>();
    std::fill(memory.bytes().begin(), memory.bytes().end(), std::uint8_t{0x55});
    EXPECT_EQ(power_on(), (Frames{"705#00", corrupt}));
}

TEST_F(SmallStore, BankWithAnUnreadableHeaderIsNotUsed) {
    verifies<req::CO_STORE_013>();
    FaultyMemory faulty{2 * bank_size};
    power_on_with(faulty);
    set_value("11223344");
    EXPECT_EQ(save(), saved);
    faulty.fail_read(1);  // the read of the first bank's header fails; the second bank is blank
    EXPECT_EQ(power_on_with(faulty), (Frames{"705#00", corrupt}));
    EXPECT_EQ(value(), "00000000");
}

TEST_F(SmallStore, UnreadableStoredValueIsReportedAndTheDefaultApplies) {
    verifies<req::CO_NMT_005, req::CO_STORE_006, req::CO_STORE_016>();
    FaultyMemory faulty{2 * bank_size};
    power_on_with(faulty);
    set_value("11223344");
    EXPECT_EQ(save(), saved);
    faulty.fail_read(0);
    power_on_with(faulty);
    EXPECT_EQ(value(), "11223344");
    EXPECT_EQ(faulty.reads, 5U) << "two headers, the bank in use in two pieces, and the value once";
    faulty.fail_read(faulty.reads);  // the last read fails: the read of the value, after the CRC was checked
    EXPECT_EQ(power_on_with(faulty), (Frames{"705#00", corrupt}));
    EXPECT_EQ(value(), "00000000");
    faulty.fail_read(0);
    EXPECT_EQ(save("02"), "585#6010100200000000");
    EXPECT_EQ(faulty.reads, 2U) << "only the new bank is read, in two pieces";
}

// A power cut before the last write of a save leaves a bank that is complete but still marked as void.
TEST_F(SmallStore, CompleteStoredSetWithoutTheCommittedMarkerIsNotLoaded) {
    verifies<req::CO_STORE_017>();
    power_on();
    set_value("11223344");
    EXPECT_EQ(save(), saved);
    set_value("55667788");
    EXPECT_EQ(save(), saved);
    std::swap(memory.bytes().at(3), memory.bytes().at(bank_size + 3));  // exchanges the markers of the two banks
    EXPECT_EQ(power_on(), Frames{"705#00"});
    EXPECT_EQ(value(), "11223344");
}

TEST_F(SmallStore, ResetCommunicationLoadsAllStoredValuesOrNone) {
    verifies<req::CO_NMT_005, req::CO_STORE_006, req::CO_STORE_016>();
    keep(0x1015);  // inhibit time EMCY
    keep(0x1017);  // producer heartbeat time
    FaultyMemory faulty{128};
    power_on_with(faulty);
    send("605#2B15100064000000");
    send("605#2B171000B80B0000");
    EXPECT_EQ(save(), saved);
    power_on_with(faulty);
    faulty.fail_read(0);
    EXPECT_EQ(send("000#8205"), Frames{"705#00"});
    EXPECT_EQ(send("605#4015100000000000"), Frames{"585#4B15100064000000"});
    EXPECT_EQ(send("605#4017100000000000"), Frames{"585#4B171000B80B0000"});
    const std::size_t reads = faulty.reads;
    ASSERT_GE(reads, 2U);
    for (std::size_t n = 1; n <= reads; ++n) {
        faulty.fail_read(0);
        power_on_with(faulty);
        faulty.fail_read(n);
        EXPECT_EQ(send("000#8205"), (Frames{"705#00", corrupt})) << n;
        EXPECT_EQ(send("605#4001100000000000"), Frames{"585#4F01100001000000"}) << n;
        EXPECT_EQ(send("605#4015100000000000"), Frames{"585#4B15100000000000"}) << n;
        EXPECT_EQ(send("605#4017100000000000"), Frames{"585#4B17100000000000"}) << n;
    }
}

TEST_F(SmallStore, FailedWriteIsReportedEvenWhenItsBytesArrived) {
    verifies<req::CO_STORE_005>();
    for (const std::size_t n : {1U, 2U, 3U, 4U, 5U}) {  // the five writes of a save: invalidate marker, header, value,
                                                        // CRC, committed marker
        FaultyMemory faulty{2 * bank_size};
        power_on_with(faulty);
        faulty.fail_write(n);
        EXPECT_EQ(save(), hardware_error) << n;
    }
}

TEST_F(SmallStore, NewStoredSetIsLoadedWhenTheOldSetCannotBeInvalidated) {
    verifies<req::CO_STORE_004>();
    FaultyMemory faulty{2 * bank_size};
    power_on_with(faulty);
    set_value("11223344");
    EXPECT_EQ(save(), saved);
    set_value("55667788");
    faulty.fail_write(6);  // the write that invalidates the old set fails; the new set is committed
    EXPECT_EQ(save(), saved);
    faulty.sound.bytes()[3] = 'S';  // undoes the invalidation of the old set, so both sets are committed
    EXPECT_EQ(power_on_with(faulty), Frames{"705#00"});
    EXPECT_EQ(value(), "55667788");
}

TEST_F(SmallStore, FirstSaveReadsOnlyTheBankThatItHasWritten) {
    verifies<req::CO_STORE_001>();
    FaultyMemory faulty{2 * bank_size};
    power_on_with(faulty);
    faulty.fail_read(3);  // a save reads back only the new bank, in two pieces (16 and 8 bytes); a third read would
                          // fail
    EXPECT_EQ(save("02"), "585#6010100200000000");
    EXPECT_EQ(faulty.reads, 2U);
}

TEST_F(SmallStore, SaveOfOneGroupKeepsALongValueOfAnotherGroupCompletely) {
    verifies<req::CO_STORE_011>();
    keep(0x2300);  // 2300h holds 40 bytes
    memory.bytes().resize(2 * (bank_size + 40));
    EXPECT_EQ(power_on(), Frames{"705#00"});
    std::array<std::uint8_t, 40> text{};
    std::iota(text.begin(), text.end(), std::uint8_t{'A'});
    ObjectDictionary& objects = device->objects();
    objects.put(objects.lookup(0x2300, 0), ByteView{text});
    set_value("11223344");
    EXPECT_EQ(save(), saved);
    objects.put(objects.lookup(0x2300, 0), ByteView{});
    set_value("55667788");
    EXPECT_EQ(save("02"), "585#6010100200000000");
    EXPECT_EQ(power_on(), Frames{"705#00"});
    EXPECT_EQ(value(), "11223344");
    const ByteView found = device->objects().value(device->objects().lookup(0x2300, 0));
    ASSERT_EQ(found.size(), text.size());
    EXPECT_TRUE(std::equal(text.begin(), text.end(), found.data()));
}

TEST_F(SmallStore, StoredValueOf64BytesIsLoadedCompletely) {
    verifies<req::CO_STORE_001>();
    keep(0x2300);
    std::vector<std::uint8_t>& image = description.rows.layout.image;
    entry(0x2300, 0).offset = static_cast<std::uint16_t>(image.size());
    entry(0x2300, 0).size = 64;
    image.resize(image.size() + 64U);
    memory.bytes().resize(2 * (bank_size + 64));
    EXPECT_EQ(power_on(), Frames{"705#00"});
    std::array<std::uint8_t, 64> text{};
    std::iota(text.begin(), text.end(), std::uint8_t{'A'});
    ObjectDictionary& objects = device->objects();
    objects.put(objects.lookup(0x2300, 0), ByteView{text});
    EXPECT_EQ(save(), saved);
    EXPECT_EQ(power_on(), Frames{"705#00"});
    const ByteView found = device->objects().value(device->objects().lookup(0x2300, 0));
    ASSERT_EQ(found.size(), text.size());
    EXPECT_TRUE(std::equal(text.begin(), text.end(), found.data()));
}

// The stored value is 5, like the node-ID of the node that saves it. But the default of this value does not depend on
// the node-ID.
TEST_F(SmallStore, StoredValueDoesNotFollowTheNodeIdWhenItsDefaultContainsNoNodeId) {
    verifies<req::CO_PDO_030, req::CO_NMT_005>();
    power_on();
    set_value("05000000");
    EXPECT_EQ(save(), saved);
    EXPECT_EQ(power_on_with(memory, 6), Frames{"706#00"});
    EXPECT_EQ(send("606#4007220000000000"), Frames{"586#4307220005000000"});
}

}  // namespace canproof::test
