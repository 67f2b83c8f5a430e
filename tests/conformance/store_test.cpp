// SPDX-License-Identifier: Apache-2.0
// Tests storing and restoring of parameters (CiA 301, 7.5.2.13, 7.5.2.14; CAN-CBX-AO412, 7.9.12, 7.9.13, 7.5.1), node
// 3.
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "generated/canopen/requirements.hpp"
#include "generated/cbx_ao412/requirements.hpp"
#include "tests/conformance/store_cases.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

TEST_F(Store, SaveAllStoresEachGroup) {
    verifies<req::CO_STORE_001, req::CO_K_STORE_SIGNATURE, req::AO4_OD_1010>();
    set_values("3412");
    EXPECT_EQ(send("603#2310100173617665"), (Frames{"583#6010100100000000"}));
    power_on();
    EXPECT_EQ(values(), "3412 3412 3412 ");
}

TEST_F(Store, NothingIsStoredWithoutASave) {
    verifies<req::CO_STORE_001>();
    set_values("3412");
    power_on();
    EXPECT_EQ(values(), "0000 0000 0000 ");
}

TEST_F(Store, EachSubIndexOfStoreParameters1010hSavesOnlyItsGroup) {
    verifies<req::CO_STORE_001, req::CO_STORE_011>();
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

TEST_F(Store, OnlyTheRightSignatureSavesOrRestores) {
    verifies<req::CO_STORE_002>();
    set_values("3412");
    for (const char* word : {"65766173", "73617664", "00000000", "6C6F6164", "01000000"}) {
        EXPECT_EQ(send(std::string{"603#23101001"} + word), (Frames{"583#8010100120000008"})) << word;
    }
    EXPECT_EQ(send("603#2311100173617665"), (Frames{"583#8011100120000008"}));
    power_on();
    EXPECT_EQ(values(), "0000 0000 0000 ");
}

TEST_F(Store, RestoredDefaultsApplyAtTheNextReset) {
    verifies<req::CO_STORE_003, req::CO_STORE_012, req::CO_K_RESTORE_SIGNATURE, req::AO4_OD_1011>();
    set_values("3412");
    write("603#2310100173617665");
    EXPECT_EQ(send("603#231110016C6F6164"), (Frames{"583#6011100100000000"}));
    EXPECT_EQ(values(), "3412 3412 3412 ");
    send("000#8103");
    EXPECT_EQ(values(), "0000 0000 0000 ");
}

TEST_F(Store, RestoreOfOneGroupKeepsTheOthersStored) {
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

TEST_F(Store, SaveIsRefusedInOperational) {
    verifies<req::AO4_STORE_001>();
    set_values("3412");
    send("000#0103");
    EXPECT_EQ(send("603#2310100173617665"), (Frames{"583#8010100122000008"}));
    // 1011h restore defaults is accepted in operational
    EXPECT_EQ(send("603#231110016C6F6164"), (Frames{"583#6011100100000000"}));
    power_on();
    EXPECT_EQ(values(), "0000 0000 0000 ");
}

TEST_F(Store, StoreParameters1010hAndRestore1011hReadAsStoringOnCommandOnly) {
    verifies<req::AO4_STORE_002, req::AO4_OD_1010, req::AO4_OD_1011>();
    for (const char* object : {"101001", "101002", "101003", "101004", "111001", "111002", "111003", "111004"}) {
        EXPECT_EQ(send(std::string{"603#40"} + object + "00000000").at(0), std::string{"583#43"} + object + "01000000");
    }
}

TEST_F(Store, EveryWritableParameterIsStored) {
    verifies<req::AO4_STORE_003>();
    // One SDO write: object (index and sub-index), command byte (which gives the length), and an accepted value other
    // than the default.
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
                                  // these come last, because a change of any other parameter clears 1020h (verify
                                  // configuration)
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

TEST_F(Store, MappingsSyncCounterAndElementsBetweenFirstAndLastAreStored) {
    verifies<req::AO4_STORE_003>();
    std::vector<std::pair<std::string, std::string>> cases{
        {"2F191000", "05000000"},  // 1019h: overflow of the SYNC counter
        {"23011401", "03030080"},  // 1401h:1: RPDO2 is not valid
        {"23021401", "03040080"},  // 1402h:1: RPDO3 is not valid
        {"2F011600", "00000000"},
        {"2F021600", "00000000"}};
    for (const std::string sub : {"01", "02", "03", "04"}) {
        cases.emplace_back("230116" + sub, "10000300");  // 1601h: a dummy entry of 16 bits
        cases.emplace_back("230216" + sub, "10011164");  // 1602h: 6411h:1 with 16 bits
    }
    cases.emplace_back("2F011600", "03000000");
    cases.emplace_back("2F021600", "02000000");
    for (const std::string sub : {"02", "03"}) {
        cases.emplace_back("2B1164" + sub, "0" + sub.substr(1) + "010000");
        cases.emplace_back("2F4364" + sub, "02000000");
        cases.emplace_back("234464" + sub, "0000" + sub + "40");
        cases.emplace_back("2B0424" + sub, sub + "020000");
        cases.emplace_back("2B0524" + sub, sub + "030000");
    }
    std::map<std::string, std::string> stored;
    for (const auto& [object, value] : cases) {
        write("603#" + object + value);
        stored[object.substr(2)] = value;
    }
    write("603#2310100173617665");
    power_on();
    for (const auto& [object, value] : stored) {
        EXPECT_EQ(send("603#40" + object + "00000000").at(0).substr(6), object + value);
    }
}

TEST_F(Store, StoredCobIdIsKeptUntilRestoreDefaults1011hSub1AndAReset) {
    verifies<req::AO4_STORE_004>();
    write("603#2314100083000080");  // 1014h COB-ID EMCY: not valid first, then 93h
    write("603#2314100093000000");
    write("603#2310100273617665");
    inputs.switch_low = 5;
    EXPECT_EQ(power_on(), (Frames{"705#00"}));
    const auto cob_id = [&] { return send("605#4014100000000000").at(0).substr(12); };
    EXPECT_EQ(send("605#231110016C6F6164"), (Frames{"585#6011100100000000"}));
    EXPECT_EQ(cob_id(), "93000000") << "before the reset";
    EXPECT_EQ(send("000#8105"), (Frames{"705#00"}));
    EXPECT_EQ(cob_id(), "85000000");
}

TEST_F(Store, ChangedAndStoredCobIdsSurviveANewSettingOfTheNodeIdSwitches) {
    verifies<req::AO4_STORE_004, req::AO4_STORE_006, req::CO_PDO_035, req::CO_PDO_060>();
    write("603#2314100083000080");  // 1014h COB-ID EMCY: not valid first, then 93h
    write("603#2314100093000000");
    write("603#2310100273617665");
    inputs.switch_low = 5;
    EXPECT_EQ(power_on(), (Frames{"705#00"}));  // the boot-up follows the node-ID: 100Eh (node guarding identifier) was
                                                // stored with its default value
    const auto cob_id = [&] { return send("605#4014100000000000").at(0).substr(12); };
    EXPECT_EQ(cob_id(), "93000000");
    EXPECT_EQ(send("605#4001140100000000"), Frames{"585#4301140105030000"});  // 1401h:1, RPDO2: 300h + 5
    EXPECT_EQ(send("605#231110026C6F6164"), (Frames{"585#6011100200000000"}));
    EXPECT_EQ(send("000#8105"), (Frames{"705#00"}));
    EXPECT_EQ(cob_id(), "85000000");
}

TEST_F(Store, StoredDefaultCobIdsFollowTheNodeIdSwitchesAfterSavesOfAnotherGroup) {
    verifies<req::AO4_STORE_006, req::CO_PDO_035, req::CO_PDO_060>();
    write("603#2310100173617665");  // 1010h:1 store parameters: saves all groups of node 3
    inputs.switch_low = 5;
    EXPECT_EQ(power_on(), (Frames{"705#00"}));
    for (int saves = 0; saves < 3; ++saves) {
        EXPECT_EQ(send("605#2310100373617665"), Frames{"585#6010100300000000"});  // application parameters only
    }
    for (int saves = 0; saves < 3; ++saves) {
        EXPECT_EQ(send("605#2310100473617665"), Frames{"585#6010100400000000"});  // manufacturer parameters only
    }
    EXPECT_EQ(power_on(), (Frames{"705#00"}));
    EXPECT_EQ(send("605#4001140100000000"), Frames{"585#4301140105030000"});  // 1401h:1, RPDO2: 300h + 5
}

TEST_F(Store, UnstoredCobIdsFollowTheNodeIdSwitches) {
    verifies<req::AO4_STORE_006>();
    write("603#2310100373617665");  // 1010h:3 store parameters: saves the application parameters only
    inputs.switch_low = 5;
    EXPECT_EQ(power_on(), (Frames{"705#00"}));
}

}  // namespace canproof::test
