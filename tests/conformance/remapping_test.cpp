// SPDX-License-Identifier: Apache-2.0
// Tests the parameters of PDOs and the order of the steps of remapping: a) to e) in the manuals (CiA 301, 7.5.2.35 to
// 7.5.2.38). The slave is the conformance slave, node 5. Receive and transmit PDOs follow the same rules.
#include "generated/canopen/requirements.hpp"
#include "tests/support/exchange.hpp"
#include "tests/support/slave_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// The objects of RPDOs or of TPDOs, written as in SDO frames: index with the lower byte first.
struct Direction {
    const char* name;
    std::string parameters;  ///< 1400h or 1800h
    std::string mapping;     ///< 1600h or 1A00h
    std::string cob_id;      ///< 205h or 185h
    std::string other_id;    ///< 215h or 195h
    std::string entry;       ///< a mappable UNSIGNED8: 2000h:3 or 2001h:3
    std::string foreign;     ///< an UNSIGNED8 that can be mapped in the other direction only

    friend std::ostream& operator<<(std::ostream& out, const Direction& direction) { return out << direction.name; }
};

const Direction receive{"RPDO", "0014", "0016", "0502", "1502", "08030020", "08030120"};
const Direction transmit{"TPDO", "0018", "001A", "8501", "9501", "08030120", "08030020"};

class Remapping : public testing::TestWithParam<Direction>, public SlaveBench {
  protected:
    /// An SDO download and the abort code that it must get; "" if it must be accepted.
    struct Write {
        std::string object;  ///< index and sub-index
        std::string data;
        std::string abort;
    };
    void hold(const std::vector<Write>& table) {
        int line = 0;
        for (const Write& row : table) {
            ++line;
            const std::string specifier = row.data.size() == 2 ? "2F" : row.data.size() == 4 ? "2B" : "23";
            const std::string padded = row.data + std::string(8 - row.data.size(), '0');
            const std::string expected =
                row.abort.empty() ? "585#60" + row.object + "00000000" : "585#80" + row.object + row.abort;
            EXPECT_EQ(send("605#" + specifier + row.object + padded), (Frames{expected}))
                << GetParam().name << ", line " << line;
        }
    }
    std::string parameter(const char* sub) const { return GetParam().parameters + sub; }
    std::string line(const char* sub) const { return GetParam().mapping + sub; }
    std::string valid() const { return GetParam().cob_id + "0000"; }
    std::string not_valid() const { return GetParam().cob_id + "0080"; }
};

const std::string present_state = "22000008";      // 08000022h
const std::string out_of_range = "30000906";       // 06090030h
const std::string object_missing = "00000206";     // 06020000h
const std::string subindex_missing = "11000906";   // 06090011h
const std::string cannot_be_mapped = "41000406";   // 06040041h
const std::string longer_than_a_pdo = "42000406";  // 06040042h
const std::string incompatible = "43000406";       // 06040043h

INSTANTIATE_TEST_SUITE_P(Both, Remapping, testing::Values(receive, transmit),
                         [](const auto& direction) { return std::string{direction.param.name}; });

}  // namespace

// -- The procedure ----------------------------------------------------------------------------------------------------

TEST_P(Remapping, RemappingStepsInThePrescribedOrderAreAccepted) {
    verifies<req::CO_PDO_009, req::CO_PDO_056>();
    hold({
        {parameter("01"), not_valid(), ""},  // a) make the PDO not valid
        {line("00"), "00", ""},              // b) disable the mapping
        {line("01"), GetParam().entry, ""},  // c) change the mapping
        {line("02"), GetParam().entry, ""},  //
        {line("00"), "02", ""},              // d) enable the mapping
        {parameter("01"), valid(), ""},      // e) make the PDO valid
    });
}

TEST_P(Remapping, EachRemappingStepOutOfOrderIsRefused) {
    verifies<req::CO_PDO_009, req::CO_PDO_056>();
    hold({
        {line("00"), "00", present_state},              // b) before a)
        {line("01"), GetParam().entry, present_state},  // c) before a)
        {line("00"), "01", present_state},              // d) before a)
        {parameter("01"), not_valid(), ""},             // a)
        {line("01"), GetParam().entry, present_state},  // c) before b)
        {line("00"), "00", ""},                         // b)
        {line("01"), GetParam().entry, ""},             // c)
        {parameter("01"), valid(), ""},                 // e) before d): the PDO becomes valid while its mapping is
                                                        // empty
        {line("00"), "01", present_state},              // d) after e)
        {parameter("01"), not_valid(), ""},
        {line("00"), "01", ""},
        {line("01"), GetParam().entry, present_state},  // c) after d)
        {parameter("01"), valid(), ""},
        {line("01"), GetParam().entry, present_state},  // c) after e)
    });
}

TEST_P(Remapping, RefusedRemappingStepChangesNothing) {
    verifies<req::CO_PDO_009, req::CO_PDO_056, req::CO_SDO_011>();
    const std::string first = GetParam().mapping == "0016" ? "08010020" : "08010120";
    hold({{line("01"), GetParam().entry, present_state}, {line("00"), "01", present_state}});
    EXPECT_EQ(send("605#40" + line("00") + "00000000"), (Frames{"585#4F" + line("00") + "02000000"}));
    EXPECT_EQ(send("605#40" + line("01") + "00000000"), (Frames{"585#43" + line("01") + first}));
}

// -- What can be mapped -----------------------------------------------------------------------------------------------

TEST_P(Remapping, ObjectsThatCannotBeMappedAreRefused) {
    verifies<req::CO_PDO_010>();
    hold({
        {parameter("01"), not_valid(), ""},
        {line("00"), "00", ""},
        {line("01"), "08003412", object_missing},    // 1234h is absent
        {line("01"), "08090020", subindex_missing},  // 2000h:9 is absent
        {line("01"), "10001710", cannot_be_mapped},  // 1017h (producer heartbeat time) is not mappable
        {line("01"), GetParam().foreign, cannot_be_mapped},
        {line("01"), "10" + GetParam().entry.substr(2), cannot_be_mapped},  // maps 16 bits of an entry of 8 bits
        {line("01"), "07" + GetParam().entry.substr(2), cannot_be_mapped},
        {line("01"), "00" + GetParam().entry.substr(2), cannot_be_mapped},
        {line("01"), "08010220", cannot_be_mapped},  // 2002h:1 is a BOOLEAN of one bit, and only an RPDO can carry it
        {line("01"), "40000722", cannot_be_mapped},  // maps 64 bits of 2207h, which has 32
        {line("01"), "00000000", ""},                // an empty entry
        {line("01"), GetParam().entry, ""},
        {line("08"), "20000722", ""},
        {line("09"), "20000722", subindex_missing},  // eight entries exist
    });
}

TEST_P(Remapping, DummiesCanBeMappedInReceivePdosOnly) {
    verifies<req::CO_PDO_012, req::CO_PDO_057>();
    const std::string expected = GetParam().mapping == "0016" ? "" : cannot_be_mapped;
    hold({
        {parameter("01"), not_valid(), ""},
        {line("00"), "00", ""},
        {line("01"), "01000100", expected},  // BOOLEAN
        {line("01"), "08000200", expected},  // INTEGER8
        {line("01"), "10000300", expected},  // INTEGER16
        {line("01"), "20000400", expected},  // INTEGER32
        {line("01"), "08000500", expected},  // UNSIGNED8
        {line("01"), "10000600", expected},  // UNSIGNED16
        {line("01"), "20000700", expected},  // UNSIGNED32
        {line("01"), "08000100", cannot_be_mapped},
        {line("01"), "01000500", cannot_be_mapped},
        {line("01"), "20000600", cannot_be_mapped},
        {line("01"), "08010500", cannot_be_mapped},  // a dummy with sub-index 1
        {line("01"), "00000500", cannot_be_mapped},  // a dummy of no bits
        {line("01"), "20000800", object_missing},    // REAL32 is no dummy
    });
}

TEST_P(Remapping, MappingCountIsRefusedForTooManyBitsEmptyEntriesOrTooManyEntries) {
    verifies<req::CO_PDO_011, req::CO_PDO_064>();
    hold({
        {parameter("01"), not_valid(), ""},
        {line("00"), "00", ""},
        {line("01"), "20000722", ""},  // 2207h: 32 bits
        {line("02"), "20000722", ""},
        {line("03"), GetParam().entry, ""},
        {line("04"), "00000000", ""},
        {line("00"), "03", longer_than_a_pdo},  // 72 bits in total
        {line("00"), "02", ""},                 // 64 bits in total
        {line("00"), "00", ""},
        {line("01"), "00000000", ""},
        {line("00"), "01", cannot_be_mapped},  // an empty entry
        {line("01"), GetParam().entry, ""},
        {line("00"), "04", cannot_be_mapped},  // refused: the fourth mapping entry is empty
        {line("00"), "09", "31000906"},        // 06090031h: this slave gives sub-index 0 a limit of 8
    });
}

/// The sum of the lengths must not wrap: eight entries of 32 bits are 256 bits, which is 0 in a sum of one byte.
TEST_P(Remapping, EightEntriesOf32BitsAreRefused) {
    verifies<req::CO_PDO_011>();
    hold({
        {parameter("01"), not_valid(), ""},
        {line("00"), "00", ""},
        {line("01"), "20000722", ""},  // 2207h: 32 bits
        {line("02"), "20000722", ""},
        {line("03"), "20000722", ""},
        {line("04"), "20000722", ""},
        {line("05"), "20000722", ""},
        {line("06"), "20000722", ""},
        {line("07"), "20000722", ""},
        {line("08"), "20000722", ""},
        {line("00"), "08", longer_than_a_pdo},
    });
}

// -- COB-ID -----------------------------------------------------------------------------------------------------------

TEST_P(Remapping, IdentifierIsLockedWhileThePdoIsValid) {
    verifies<req::CO_PDO_007, req::CO_PDO_006>();
    const std::string other = GetParam().other_id;
    hold({
        {parameter("01"), other + "0000", present_state},
        {parameter("01"), other + "0040", present_state},
        {parameter("01"), valid(), ""},                     // accepted: the same COB-ID again
        {parameter("01"), GetParam().cob_id + "0040", ""},  // bit 30 may change while the PDO is valid
        {parameter("01"), other + "0080", ""},              // a write that sets bit 31 (not valid) may change the
                                                            // identifier
        {parameter("01"), other + "0000", ""},
    });
}

TEST_P(Remapping, ReservedBitsOfTheCobIdAreRefused) {
    verifies<req::CO_PDO_054>();
    const std::string id = GetParam().cob_id;
    hold({
        {parameter("01"), id + "0020", out_of_range},                 // bit 29: 29-bit identifiers
        {parameter("01"), id + "00A0", out_of_range},                 // bits 31 and 29
        {parameter("01"), id + "0010", out_of_range},                 // bit 28
        {parameter("01"), id + "0100", out_of_range},                 // bit 16
        {parameter("01"), id.substr(0, 2) + "0A0000", out_of_range},  // bit 11
    });
}

TEST_P(Remapping, RestrictedIdentifiersAreRefusedUnlessBit31IsSet) {
    verifies<req::CO_PDO_055, req::CO_T_RESTRICTED_COB_ID>();
    hold({{parameter("01"), not_valid(), ""}});
    // CiA 301, 7.3.5: 000h, 001h-07Fh, 101h-180h, 581h-5FFh, 601h-67Fh, 6E0h-6FFh, 701h-77Fh, 780h-7FFh
    for (const char* id : {"0000", "0100", "7F00", "0101", "8001", "8105", "FF05", "0106", "7F06", "E006", "FF06",
                           "0107", "7F07", "8007", "FF07"}) {
        hold({{parameter("01"), std::string{id} + "0000", out_of_range}});
        hold({{parameter("01"), std::string{id} + "0080", ""}});  // with bit 31 set, any identifier is accepted
    }
    for (const char* id : {"8101", "8005", "8006", "DF06"}) {
        hold({{parameter("01"), std::string{id} + "0000", ""}, {parameter("01"), std::string{id} + "0080", ""}});
    }
}

TEST_P(Remapping, IdentifierSharedByATpdoAndAnotherPdoIsRefused) {
    verifies<req::CO_PDO_026>();
    hold({
        {parameter("01"), not_valid(), ""},
        {parameter("01"), "85010000", GetParam().parameters == "0018" ? "" : incompatible},  // 185h: TPDO1
        {parameter("01"), "85010080", ""},
        {parameter("01"), "85020000", incompatible},  // 285h: TPDO2
        {parameter("01"), "85020080", ""},            // not valid (bit 31), so it causes no conflict with TPDO2
        {parameter("01"), "85030000", ""},            // accepted: TPDO3, which also has 385h, is not valid
        {parameter("01"), "85030080", ""},
        {parameter("01"), "05030000", GetParam().parameters == "0018" ? incompatible : ""},  // 305h: RPDO2
    });
}

// -- The other parameters ---------------------------------------------------------------------------------------------

TEST_P(Remapping, ReservedTransmissionTypesAreRefused) {
    verifies<req::CO_PDO_008, req::CO_T_TRANSMISSION_TYPE>();
    const std::string on_request = GetParam().parameters == "0018" ? "" : out_of_range;
    hold({
        {parameter("02"), "00", ""},
        {parameter("02"), "01", ""},
        {parameter("02"), "F0", ""},
        {parameter("02"), "F1", out_of_range},  // type 241 is reserved
        {parameter("02"), "F2", out_of_range},
        {parameter("02"), "FA", out_of_range},
        {parameter("02"), "FB", out_of_range},  // type 251 is reserved
        {parameter("02"), "FC", on_request},
        {parameter("02"), "FD", on_request},
        {parameter("02"), "FE", ""},
        {parameter("02"), "FF", ""},
    });
}

TEST_P(Remapping, InhibitTimeIsLockedWhileThePdoIsValid) {
    verifies<req::CO_PDO_023>();
    hold({
        {parameter("03"), "6400", present_state},
        {parameter("01"), not_valid(), ""},
        {parameter("03"), "6400", ""},
        {parameter("03"), "FFFF", ""},
        {parameter("01"), valid(), ""},
        {parameter("03"), "0000", present_state},
        {parameter("03"), "FFFF", present_state},  // even a write of the present value is refused
    });
}

TEST_P(Remapping, EventTimerCanChangeWhileThePdoIsValid) {
    verifies<req::CO_PDO_051, req::CO_PDO_039>();
    hold({
        {parameter("05"), "6400", ""},
        {parameter("05"), "0000", ""},
        {parameter("04"), "00", subindex_missing},  // sub-index 4 (compatibility entry) does not exist in this slave
    });
}

class StartValue : public testing::Test, public SlaveBench {};

TEST_F(StartValue, SyncStartValueIsLockedWhileThePdoIsValidAndIsAtMost240) {
    verifies<req::CO_PDO_024, req::CO_PDO_058>();
    talk(*this, {
                    {"605#2F00180601000000", {"585#8000180622000008"}},
                    {"605#2F00180600000000", {"585#8000180622000008"}},  // even a write of the present value is refused
                    {"605#2300180185010080", {"585#6000180100000000"}},
                    {"605#2F001806F0000000", {"585#6000180600000000"}},
                    // this slave accepts a SYNC start value of at most 240
                    {"605#2F001806F1000000", {"585#8000180631000906"}},
                    {"605#2F00180600000000", {"585#6000180600000000"}},
                });
}

// -- Node-ID ----------------------------------------------------------------------------------------------------------

class DefaultIdentifiers : public testing::Test, public SlaveBench {};

TEST_F(DefaultIdentifiers, DefaultIdentifiersFollowTheNodeId) {
    verifies<req::CO_PDO_030>();
    talk(*this, {
                    {"605#4000140100000000", {"585#4300140105020000"}},  // COB-ID of RPDO1: 205h
                    {"605#4003140100000000", {"585#4303140105050080"}},  // COB-ID of RPDO4: 505h, not valid
                    {"605#4000180100000000", {"585#4300180185010000"}},  // COB-ID of TPDO1: 185h
                    {"605#4003180100000000", {"585#4303180185040080"}},  // COB-ID of TPDO4: 485h, not valid
                });
    node_id = 0x2A;
    EXPECT_EQ(power_on(), (Frames{"72A#00"}));
    talk(*this, {
                    {"62A#4000140100000000", {"5AA#430014012A020000"}},
                    {"62A#4000180100000000", {"5AA#43001801AA010000"}},
                    {"000#012A", {"1AA#0000"}},
                    {"22A#1122", {}},
                    {"62A#4000200100000000", {"5AA#4F00200111000000"}},
                });
}

TEST_F(DefaultIdentifiers, StoredIdentifierStaysWhenTheNodeIdChanges) {
    verifies<req::CO_PDO_030>();
    talk(*this, {
                    {"605#2300140105020080", {"585#6000140100000000"}},
                    {"605#2300140133020000", {"585#6000140100000000"}},  // 1400h:1 COB-ID of RPDO1: 233h
                    {"605#2310100173617665", {"585#6010100100000000"}},  // 1010h:1 store parameters: save
                });
    node_id = 0x2A;
    power_on();
    EXPECT_EQ(send("62A#4000140100000000"), (Frames{"5AA#4300140133020000"}));
}

}  // namespace canproof::test
