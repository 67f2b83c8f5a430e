// SPDX-License-Identifier: Apache-2.0
// Tests which changes of values trigger a TPDO of an event-driven type (CiA 301, 7.2.2.2), on the conformance slave,
// node 5, with changed object dictionaries.
#include <gtest/gtest.h>

#include "firmware/canopen/pdo_mapping.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/support/altered_slave.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

class PdoChange : public testing::Test, public AlteredSlaveBench {};

TEST_F(PdoChange, ChangeOfAMappedEntryWhoseHashSetsOnlyBit0TriggersItsTpdo) {
    verifies<req::CO_PDO_015>();
    // The node finds the TPDOs of a changed entry by a hash of 64 bits (watch_mark), in which one bit is set: bit
    // (index + index / 16 + sub-index) modulo 64. For 2001h:63 this is 2001h + 200h + 63, bit 0.
    ASSERT_EQ(watch_mark(0x2001, 63), 1U);
    extend(0x2001, 63);
    ship(0x1A00, 0, 1);
    ship(0x1A00, 1, 0x20013F08);
    power_on();
    EXPECT_EQ(send("000#0105"), Frames{"185#00"});
    EXPECT_EQ(send("605#2F01203F11000000"), (Frames{"185#11", "585#6001203F00000000"}));
}

TEST_F(PdoChange, SdoDownloadOfAnUnchangedValueTriggersNoTpdo) {
    verifies<req::CO_PDO_015>();
    entry(0x2001, 1).service = Service::device;
    ship(0x1A00, 0, 1);
    ship(0x1A00, 1, 0x20010108);
    power_on();
    EXPECT_EQ(send("000#0105"), Frames{"185#00"});
    EXPECT_EQ(send("605#2F01200111000000"), (Frames{"185#11", "585#6001200100000000"}));
    EXPECT_EQ(send("605#2F01200111000000"), Frames{"585#6001200100000000"}) << "the same value";
    EXPECT_EQ(send("605#2F01200112000000"), (Frames{"185#12", "585#6001200100000000"}));
}

TEST_F(PdoChange, RpdoWithAnUnchangedValueTriggersNoTpdo) {
    verifies<req::CO_PDO_015>();
    EntryRow& row = entry(0x2206, 0);  // 64 bits
    row.rights = static_cast<std::uint8_t>(row.rights | rights::rpdo | rights::tpdo);
    row.service = Service::device;
    for (const std::uint16_t mapping : {std::uint16_t{0x1600}, std::uint16_t{0x1A00}}) {
        ship(mapping, 0, 1);
        ship(mapping, 1, 0x22060040);
    }
    power_on();
    EXPECT_EQ(send("000#0105"), Frames{"185#0000000000000000"});
    EXPECT_EQ(send("205#0102030405060708"), Frames{"185#0102030405060708"});
    EXPECT_EQ(send("205#0102030405060708"), Frames{}) << "the same value";
    EXPECT_EQ(send("205#0102030405060709"), Frames{"185#0102030405060709"});
}

/// No service and no device owns the value and nothing limits it, so the node writes all values of the RPDO at once.
TEST_F(PdoChange, RpdoThatChangesAValueWithoutAnOwnerTriggersItsTpdo) {
    verifies<req::CO_PDO_015>();
    EntryRow& row = entry(0x2207, 0);  // 32 bits
    row.rights = static_cast<std::uint8_t>(row.rights | rights::rpdo | rights::tpdo);
    row.service = Service::none;
    row.limit = no_limit;
    for (const std::uint16_t mapping : {std::uint16_t{0x1600}, std::uint16_t{0x1A00}}) {
        ship(mapping, 0, 1);
        ship(mapping, 1, 0x22070020);
    }
    power_on();
    EXPECT_EQ(send("000#0105"), Frames{"185#00000000"});
    EXPECT_EQ(send("205#01020304"), Frames{"185#01020304"});
    EXPECT_EQ(send("205#01020304"), Frames{}) << "the same value";
    EXPECT_EQ(send("205#01020305"), Frames{"185#01020305"});
}

}  // namespace canproof::test
