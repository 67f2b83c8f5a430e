// SPDX-License-Identifier: Apache-2.0
// Tests transmit PDOs of types 0 to 240, 252 and 253, which SYNC or remote frames trigger (CiA 301, 7.2.2, 7.5.2.37).
#include <fmt/format.h>

#include "generated/canopen/requirements.hpp"
#include "tests/conformance/tpdo_cases.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

// -- Types 0 to 240 ---------------------------------------------------------------------------------------------------

TEST_F(Tpdo, TpdoOfType0IsSentAtTheSyncAfterAChange) {
    verifies<req::CO_PDO_013, req::CO_T_TRANSMISSION_TYPE>();
    silence_tpdo2();
    set_type("00");
    talk(*this, {
                    {"000#0105", {}},
                    {"080#", {}},
                    {"605#2F01200111000000", {"585#6001200100000000"}},
                    {"605#2F01200222000000", {"585#6001200200000000"}},
                    {"080#", {"185#1122"}},
                    {"080#", {}},
                    {"605#2F01200222000000", {"585#6001200200000000"}},  // writes the present value: no change
                    {"080#", {}},
                    {"605#2F01200200000000", {"585#6001200200000000"}},
                    {"080#", {"185#1100"}},
                });
}

TEST_F(Tpdo, TpdoOfType3IsSentAtEveryThirdSync) {
    verifies<req::CO_PDO_014, req::CO_T_TRANSMISSION_TYPE>();
    silence_tpdo2();
    set_type("03");
    talk(*this, {
                    {"000#0105", {}},
                    {"080#", {}},
                    {"605#2F01200111000000", {"585#6001200100000000"}},
                    {"080#", {}},
                    {"080#", {"185#1100"}},
                    {"080#", {}},
                    {"080#", {}},
                    {"080#", {"185#1100"}},
                    {"080#", {}},
                    {"000#8005", {}},
                    {"080#", {}},
                    {"000#0105", {}},  // the count of SYNCs restarts
                    {"080#", {}},
                    {"080#", {}},
                    {"080#", {"185#1100"}},
                });
}

TEST_F(Tpdo, TpdosOfTypes1And240AreSentAtEverySyncAndEvery240thSync) {
    verifies<req::CO_PDO_014>();
    set_type("F0");
    send("000#0105");
    for (int sync = 1; sync <= 480; ++sync) {
        const Frames expected = (sync % 240 == 0) ? Frames{"185#0000", "285#0000000000000000"}
                                                  // TPDO2 is of type 1 and is sent at every SYNC
                                                  : Frames{"285#0000000000000000"};
        EXPECT_EQ(send("080#"), expected) << sync;
    }
}

TEST_F(Tpdo, SyncStartValueSelectsTheFirstSync) {
    verifies<req::CO_PDO_019, req::CO_SYNC_001>();
    silence_tpdo2();
    talk(*this, {
                    // 1019h synchronous counter overflow value: 10, so the counter runs from 1 to 10
                    {"605#2F1910000A000000", {"585#6019100000000000"}},
                    {"605#2300180185010080", {"585#6000180100000000"}},
                    {"605#2F00180202000000", {"585#6000180200000000"}},  // transmission type 2: every second SYNC
                    {"605#2F00180604000000", {"585#6000180600000000"}},  // SYNC start value 4
                    {"605#2300180185010000", {"585#6000180100000000"}},
                    {"000#0105", {}},
                    {"080#02", {}},
                    {"080#03", {}},
                    {"080#04", {}},  // the SYNC with the start value, from which the count begins
                    {"080#05", {"185#0000"}},
                    {"080#06", {}},
                    {"080#07", {"185#0000"}},
                    {"080#08", {}},
                    {"080#09", {"185#0000"}},
                    {"080#0A", {}},
                    {"080#01", {"185#0000"}},
                    {"000#8005", {}},
                    {"000#0105", {}},
                    {"080#05", {}},
                    {"080#06", {}},
                    {"080#07", {}},
                    {"080#04", {}},
                    {"080#05", {"185#0000"}},
                });
}

TEST_F(Tpdo, TpdoOfType240CountsFromItsSyncStartValue) {
    verifies<req::CO_PDO_019, req::CO_PDO_014>();
    silence_tpdo2();
    talk(*this, {
                    {"605#2F191000F0000000", {"585#6019100000000000"}},  // 1019h: counter 1 … 240
                    {"605#2300180185010080", {"585#6000180100000000"}},
                    {"605#2F001802F0000000", {"585#6000180200000000"}},  // 1800h:2 transmission type: every 240th SYNC
                    {"605#2F00180601000000", {"585#6000180600000000"}},  // 1800h:6 SYNC start value: 1
                    {"605#2300180185010000", {"585#6000180100000000"}},
                    {"000#0105", {}},
                });
    for (int counter = 2; counter <= 240; ++counter) {  // SYNCs are counted only from the one with counter 1 (the start
                                                        // value) on
        EXPECT_TRUE(send(fmt::format("080#{:02X}", counter)).empty()) << counter;
    }
    for (int round = 0; round < 2; ++round) {
        for (int counter = 1; counter <= 239; ++counter) {
            EXPECT_TRUE(send(fmt::format("080#{:02X}", counter)).empty()) << counter;
        }
        EXPECT_EQ(send("080#F0"), (Frames{"185#0000"})) << "the 240th SYNC from the start value on";
    }
}

TEST_F(Tpdo, TpdoIsSentFromTheFirstSyncOnWithoutASyncStartValue) {
    verifies<req::CO_PDO_019, req::CO_PDO_014>();
    send("605#2F1910000A000000");  // 1019h synchronous counter overflow value: counter 1 … 10
    EXPECT_EQ(send("000#0105"), (Frames{"185#0000"}));
    EXPECT_EQ(send("080#07"), (Frames{"285#0000000000000000"}));  // TPDO2 is of type 1
    EXPECT_EQ(send("080#08"), (Frames{"285#0000000000000000"}));
}

TEST_F(Tpdo, SyncStartValueHasNoEffectWithoutASyncCounter) {
    verifies<req::CO_PDO_050>();
    silence_tpdo2();
    talk(*this, {
                    {"605#2300180185010080", {"585#6000180100000000"}},
                    {"605#2F00180201000000", {"585#6000180200000000"}},
                    {"605#2F00180604000000", {"585#6000180600000000"}},
                    {"605#2300180185010000", {"585#6000180100000000"}},
                    {"000#0105", {}},
                    {"080#", {"185#0000"}},
                    {"080#", {"185#0000"}},
                });
}

TEST_F(Tpdo, ProducedSyncAndItsCounterTriggerTheProducersTpdos) {
    verifies<req::CO_SYNC_005, req::CO_PDO_019>();
    silence_tpdo2();
    talk(*this, {
                    // 1019h synchronous counter overflow value: 3, so the counter runs from 1 to 3
                    {"605#2F19100003000000", {"585#6019100000000000"}},
                    {"605#2300180185010080", {"585#6000180100000000"}},
                    {"605#2F00180203000000", {"585#6000180200000000"}},
                    {"605#2F00180602000000", {"585#6000180600000000"}},
                    {"605#2300180185010000", {"585#6000180100000000"}},
                    {"000#0105", {}},
                    {"605#2306100010270000", {"585#6006100000000000"}},  // 1006h communication cycle period: 10 ms
                    {"605#2305100080000040", {"585#6005100000000000"}},
                });
    EXPECT_EQ(pass(70), (Frames{"10:080#01", "20:080#02", "30:080#03", "40:080#01", "40:185#0000", "50:080#02",
                                "60:080#03", "70:080#01", "70:185#0000"}));
}

TEST_F(Tpdo, ProducedSyncWithoutACounterTriggersATpdoDespiteItsSyncStartValue) {
    verifies<req::CO_SYNC_005, req::CO_PDO_050>();
    silence_tpdo2();
    talk(*this, {
                    {"605#2300180185010080", {"585#6000180100000000"}},
                    {"605#2F00180201000000", {"585#6000180200000000"}},
                    {"605#2F00180604000000", {"585#6000180600000000"}},
                    {"605#2300180185010000", {"585#6000180100000000"}},
                    {"000#0105", {}},
                    {"605#2306100010270000", {"585#6006100000000000"}},  // 1006h communication cycle period: 10 ms
                    {"605#2305100080000040", {"585#6005100000000000"}},
                });
    EXPECT_EQ(pass(20), (Frames{"10:080#", "10:185#0000", "20:080#", "20:185#0000"}));
}

TEST_F(Tpdo, EventTimerSendsNoSynchronousTpdo) {
    verifies<req::CO_PDO_014, req::CO_PDO_013>();
    send("000#0105");
    EXPECT_EQ(send("605#2B01180564000000"), (Frames{"585#6001180500000000"}));  // TPDO2, type 1: 100 ms
    EXPECT_TRUE(pass(1000).empty());
    EXPECT_EQ(send("080#"), (Frames{"285#0000000000000000"}));
}

TEST_F(Tpdo, SyncOfWrongLengthTriggersNoTpdo) {
    verifies<req::CO_SYNC_009>();
    start();
    EXPECT_EQ(send("080#01"), (Frames{"085#4082110100000000"}));  // error 8240h
    EXPECT_EQ(send("080#"), (Frames{"085#0000000100000000", "285#0000000000000000"}));
}

TEST_F(Tpdo, TpdosSampleTheirValuesBeforeRpdosAreAppliedAtASync) {
    verifies<req::CO_PDO_029>();
    silence_tpdo2();
    // 2207h is mapped into RPDO3 and TPDO3, both of type 1
    map_tpdo3({"20000722"});
    talk(*this, {
                    {"605#2F02180201000000", {"585#6002180200000000"}},
                    {"605#2302160120000722", {"585#6002160100000000"}},
                    {"605#2F02160001000000", {"585#6002160000000000"}},
                    {"605#2F02140201000000", {"585#6002140200000000"}},
                    {"605#2302140105040000", {"585#6002140100000000"}},
                    {"000#0105", {"185#0000"}},
                    {"405#11223344", {}},
                    {"080#", {"385#00000000"}},
                    {"080#", {"385#11223344"}},
                });
}

// -- Requests ---------------------------------------------------------------------------------------------------------

TEST_F(Tpdo, TpdoOfType253IsSentOnRequestOnly) {
    verifies<req::CO_PDO_045, req::CO_T_TRANSMISSION_TYPE>();
    silence_tpdo2();
    set_type("FD");
    send("605#2B0018050A000000");  // 1800h:5 event timer: 10 ms, without effect with this transmission type
    talk(*this, {
                    {"000#0105", {}},
                    {"605#2F01200111000000", {"585#6001200100000000"}},
                    {"080#", {}},
                    {"185#R2", {"185#1100"}},
                    {"185#R0", {"185#1100"}},
                    {"605#2F01200122000000", {"585#6001200100000000"}},
                    {"185#R8", {"185#2200"}},
                });
    EXPECT_TRUE(pass(100).empty());
}

TEST_F(Tpdo, TpdoOfType252IsSentAtNoSync) {
    verifies<req::CO_T_TRANSMISSION_TYPE>();
    silence_tpdo2();
    set_type("FC");
    send("000#0105");
    for (int syncs = 0; syncs < 300; ++syncs) {  // more than 252 SYNCs
        EXPECT_TRUE(send("080#").empty()) << syncs;
    }
}

TEST_F(Tpdo, TpdoOfType252CarriesTheValuesOfTheLastSync) {
    verifies<req::CO_PDO_043, req::CO_PDO_044, req::CO_T_TRANSMISSION_TYPE>();
    silence_tpdo2();
    set_type("FC");
    talk(*this, {
                    {"000#0105", {}},
                    {"185#R2", {}},  // no answer: values are sampled only at a SYNC, and none has come yet
                    {"605#2F01200111000000", {"585#6001200100000000"}},
                    {"080#", {}},
                    {"605#2F01200122000000", {"585#6001200100000000"}},
                    {"185#R2", {"185#1100"}},
                    {"185#R2", {"185#1100"}},
                    {"080#", {}},
                    {"185#R2", {"185#2200"}},
                    {"000#8005", {}},
                    {"000#0105", {}},
                    {"185#R2", {}},
                });
}

TEST_F(Tpdo, SynchronousTpdosAnswerRequestsWithTheValuesOfTheLastSync) {
    verifies<req::CO_PDO_043, req::CO_PDO_044>();
    silence_tpdo2();
    for (const char* type : {"00", "05", "F0"}) {
        power_on();
        silence_tpdo2();
        set_type(type);
        talk(*this, {
                        {"000#0105", {}},
                        {"185#R2", {}},  // no SYNC yet
                        {"080#", {}},
                        {"605#2F01200111000000", {"585#6001200100000000"}},
                        {"185#R2", {"185#0000"}},
                    });
    }
}

TEST_F(Tpdo, EventDrivenTpdoAnswersARequestAfterTheInhibitTime) {
    verifies<req::CO_PDO_046>();
    start();
    EXPECT_EQ(send("185#R2"), (Frames{"185#0000"}));
    send("000#8005");
    set_inhibit_time("6400");  // an inhibit time of 10 ms
    start();
    EXPECT_TRUE(send("185#R2").empty());
    EXPECT_EQ(pass(30), (Frames{"10:185#0000"}));
    EXPECT_EQ(send("185#R2"), (Frames{"185#0000"}));
}

TEST_F(Tpdo, Bit30OfTheCobIdForbidsRemoteRequests) {
    verifies<req::CO_PDO_016>();
    silence_tpdo2();
    for (const char* type : {"FE", "FD", "FC", "01", "00"}) {
        power_on();
        silence_tpdo2();
        set_type(type);
        send("605#2300180185010040");
        send("000#0105");
        send("080#");
        EXPECT_TRUE(send("185#R2").empty()) << type;
        EXPECT_EQ(send("605#2300180185010000"), (Frames{"585#6000180100000000"}));
        send("080#");
        EXPECT_EQ(send("185#R2"), (Frames{"185#0000"})) << type;
    }
}

// A client may change bit 30 of 1800h:1 (COB-ID of TPDO1) while the TPDO is valid.
TEST_F(Tpdo, SyncSamplesTheValuesAlsoWhileBit30ForbidsRemoteFrames) {
    verifies<req::CO_PDO_043>();
    silence_tpdo2();
    set_type("FC");  // type 252: a SYNC samples the values, a remote frame requests them
    talk(*this, {
                    {"000#0105", {}},
                    {"080#", {}},
                    {"605#2300180185010040", {"585#6000180100000000"}},  // sets bit 30
                    {"605#2F01200111000000", {"585#6001200100000000"}},
                    {"080#", {}},
                    {"605#2F01200122000000", {"585#6001200100000000"}},
                    {"605#2300180185010000", {"585#6000180100000000"}},  // clears bit 30
                    {"185#R2", {"185#1100"}},
                });
}

TEST_F(Tpdo, FirstSyncSamplesTheValuesWhileBit30ForbidsRemoteFrames) {
    verifies<req::CO_PDO_043, req::CO_PDO_044>();
    silence_tpdo2();
    set_type("FC");
    talk(*this, {
                    {"605#2300180185010040", {"585#6000180100000000"}},  // sets bit 30
                    {"000#0105", {}},
                    {"080#", {}},
                    {"605#2300180185010000", {"585#6000180100000000"}},  // clears bit 30
                    {"185#R2", {"185#0000"}},
                });
}

// CiA 301, 7.2.5: the counter runs from 1 to the value of 1019h (synchronous counter overflow value).
TEST_F(Tpdo, SyncWithTheInvalidCounter0DoesNotBeginTheCountFromTheSyncStartValue) {
    verifies<req::CO_PDO_019>();
    silence_tpdo2();
    talk(*this, {
                    {"605#2F1910000A000000", {"585#6019100000000000"}},  // 1019h: counter 1 … 10
                    {"605#2300180185010080", {"585#6000180100000000"}},
                    {"605#2F00180201000000", {"585#6000180200000000"}},  // transmission type 1: every SYNC
                    {"605#2F00180604000000", {"585#6000180600000000"}},  // SYNC start value 4
                    {"605#2300180185010000", {"585#6000180100000000"}},
                    {"000#0105", {}},
                    {"080#00", {}},
                    {"080#03", {}},
                    {"080#04", {"185#0000"}},
                    {"080#05", {"185#0000"}},
                });
}

TEST_F(Tpdo, OnlyRemoteFramesOfTheElevenBitIdentifierRequestATpdo) {
    verifies<req::CO_PDO_016, req::CO_PDO_006, req::CO_FRAME_001>();
    start();
    talk(*this, {
                    {"00000185#R2", {}},
                    {"184#R2", {}},
                    {"385#R2", {}},  // TPDO3 is not valid
                    {"185#1122", {}},
                });
}

}  // namespace canproof::test
