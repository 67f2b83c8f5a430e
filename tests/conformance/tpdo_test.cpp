// Transmit PDOs (CiA 301, 7.2.2, 7.5.2.37), held against the conformance slave, node 5. It has
//   TPDO1 on 185h, type 254: 2001h:1, 2001h:2 (UNSIGNED8);  TPDO2 on 285h, type 1: 2101h:1…4 (INTEGER16);
//   TPDO3 on 385h and TPDO4 on 485h: not valid. Its event is a change of value.
#include "generated/canopen/requirements.hpp"
#include "tests/support/exchange.hpp"
#include "tests/support/slave_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Tpdo : public testing::Test, public SlaveBench {
  protected:
    void start() { EXPECT_EQ(send("000#0105"), (Frames{"185#0000"})); }
    /// TPDO1 gets another transmission type; in pre-operational.
    void set_type(const std::string& type) {
        EXPECT_EQ(send("605#2F001802" + type + "000000"), (Frames{"585#6000180200000000"}));
    }
    /// TPDO2 is switched off, so that a SYNC shows TPDO1 alone.
    void silence_tpdo2() { EXPECT_EQ(send("605#2301180185020080"), (Frames{"585#6001180100000000"})); }
    /// 1800h:3 while TPDO1 is not valid.
    void set_inhibit_time(const std::string& value) {
        talk(*this, {
                        {"605#2300180185010080", {"585#6000180100000000"}},
                        {"605#2B001803" + value + "0000", {"585#6000180300000000"}},
                        {"605#2300180185010000", {"585#6000180100000000"}},
                    });
    }
    void map_tpdo3(const std::vector<std::string>& entries) {
        send("605#2302180185030080");
        send("605#2F021A0000000000");
        int line = 0;
        for (const auto& entry : entries) {
            ++line;
            const std::string object = "021A0" + std::to_string(line);
            EXPECT_EQ(send("605#23" + object + entry), (Frames{"585#60" + object + "00000000"}));
        }
        send("605#2F021A000" + std::to_string(line) + "000000");
        EXPECT_EQ(send("605#2302180185030000"), (Frames{"585#6002180100000000"}));
    }
};

}  // namespace

// -- Entering and leaving operational ---------------------------------------------------------------------------------

TEST_F(Tpdo, EventDrivenOnesAreSentOnceOnEnteringOperational) {
    verifies<req::CO_PDO_018>();
    talk(*this, {
                    {"000#0105", {"185#0000"}},
                    {"000#0105", {}},  // it was operational already
                    {"000#8005", {}},
                    {"605#2F01200155000000", {"585#6001200100000000"}},
                    {"000#0105", {"185#5500"}},
                    {"605#2F001802FF000000", {"185#5500", "585#6000180200000000"}},
                    {"000#0205", {}},
                    {"000#0105", {"185#5500"}},
                });
}

TEST_F(Tpdo, NoneIsSentOutsideOperational) {
    verifies<req::CO_PDO_027>();
    talk(*this, {
                    {"605#2B0018050A000000", {"585#6000180500000000"}},  // 10 ms
                    {"605#2F01200111000000", {"585#6001200100000000"}},
                    {"080#", {}},
                    {"185#R2", {}},
                    {"285#R8", {}},
                });
    EXPECT_TRUE(pass(100).empty());
    EXPECT_EQ(send("000#0105"), (Frames{"185#1100"}));
    EXPECT_EQ(pass(10), (Frames{"10:185#1100"}));
    talk(*this, {
                    {"000#0205", {}},
                    {"080#", {}},
                    {"185#R2", {}},
                });
    EXPECT_TRUE(pass(100).empty());
}

TEST_F(Tpdo, AnEventOutsideOperationalIsNotToldLater) {
    verifies<req::CO_PDO_027>();
    silence_tpdo2();
    set_type("00");
    talk(*this, {
                    {"605#2F01200111000000", {"585#6001200100000000"}},
                    {"000#0105", {}},
                    {"080#", {}},
                    {"605#2F01200122000000", {"585#6001200100000000"}},
                    {"000#8005", {}},
                    {"000#0105", {}},
                    {"080#", {}},
                });
}

// -- Types 254 and 255 ------------------------------------------------------------------------------------------------

TEST_F(Tpdo, AChangeOfAMappedValueIsSentAtOnce) {
    verifies<req::CO_PDO_015, req::CO_T_TRANSMISSION_TYPE>();
    for (const char* type : {"FE", "FF"}) {
        power_on();
        set_type(type);
        start();
        talk(*this, {
                        {"605#2F01200111000000", {"185#1100", "585#6001200100000000"}},
                        {"605#2F01200111000000", {"585#6001200100000000"}},  // the same value
                        {"605#2F01200222000000", {"185#1122", "585#6001200200000000"}},
                        {"605#2F01200333000000", {"585#6001200300000000"}},  // not mapped
                        {"605#2B01210101000000", {"585#6001210100000000"}},  // in TPDO2, of type 1
                        {"605#2F01200100000000", {"185#0022", "585#6001200100000000"}},
                        {"080#", {"285#0100000000000000"}},
                        {"605#2B01210100000000", {"585#6001210100000000"}},
                    });
    }
}

TEST_F(Tpdo, ValuesThatChangeTogetherLeaveTogether) {
    verifies<req::CO_PDO_015>();
    // 2200h (INTEGER16) and 2207h (UNSIGNED32) both in RPDO3 on 405h and in TPDO3 on 385h
    map_tpdo3({"10000022", "20000722"});
    talk(*this, {
                    {"605#2302140105040080", {"585#6002140100000000"}},
                    {"605#2302160110000022", {"585#6002160100000000"}},
                    {"605#2302160220000722", {"585#6002160200000000"}},
                    {"605#2F02160002000000", {"585#6002160000000000"}},
                    {"605#2302140105040000", {"585#6002140100000000"}},
                    {"000#0105", {"185#0000", "385#070000000000"}},
                    {"405#050011223344", {"385#050011223344"}},
                    {"405#050011223344", {}},  // the same values
                    {"405#050011223345", {"385#050011223345"}},
                    {"405#650011223344", {"085#0082110100000000"}},  // 101 is too high: nothing is taken or changes
                });
}

TEST_F(Tpdo, TheDeviceTellsOfItsOwnChanges) {
    verifies<req::CO_PDO_015>();
    start();
    device->objects().write(0x2001, 2, 0x77);
    device->node().process_value_changed(0x2001, 2, now);
    EXPECT_LE(device->next_deadline(), now);
    device->advance(now);
    EXPECT_EQ(sent(), (Frames{"185#0077"}));
    device->node().process_value_changed(0x2001, 3, now);  // mapped nowhere
    device->node().process_value_changed(0x2101, 1, now);  // TPDO2 is of type 1
    device->advance(now);
    EXPECT_TRUE(sent().empty());
    EXPECT_EQ(device->next_deadline(), never);
}

TEST_F(Tpdo, WritesToOtherParametersLetTheEventTimerRun) {
    verifies<req::CO_PDO_025>();
    EXPECT_EQ(send("605#2B00180564000000"), (Frames{"585#6000180500000000"}));  // 100 ms
    start();
    EXPECT_TRUE(pass(60).empty());
    EXPECT_EQ(send("605#2300180185010000"), (Frames{"585#6000180100000000"}));  // its identifier, as it is
    EXPECT_EQ(pass(40), (Frames{"40:185#0000"}));
}

TEST_F(Tpdo, AChangeOfTheErrorRegisterIsSentToo) {
    verifies<req::CO_PDO_015>();
    map_tpdo3({"08000110"});  // 1001h
    talk(*this, {
                    {"000#0105", {"185#0000", "385#00"}},
                    {"205#11", {"085#1082110100000000", "385#11"}},  // RPDO1 is too short
                    {"205#22", {}},
                    {"205#1122", {"085#0000000100000000", "385#00"}},
                });
    device->node().set_overrun(true, now);
    EXPECT_EQ(sent().size(), 1U);  // 8110h
    EXPECT_EQ(pass(1), (Frames{"0:385#11"}));
}

// -- A device whose only event is the event timer (AX130751, 3.2.15) --------------------------------------------------

namespace {

/// The TPDO service alone, on the dictionary of the slave.
class TimeDriven : public Tpdo {
  protected:
    void begin() {
        service.reset();
        service.start(now);
        service.advance(now);
    }
    TransmitQueue own_queue;
    SizedPdoMemory<0, max_pdos, max_pdo_lines> pdo_memory;
    TransmitPdos service{pdo_memory.memory().sent, pdo_memory.memory().sent_lines, device->objects(), own_queue,
                         TpdoTrigger::event_timer};
};

}  // namespace

TEST_F(TimeDriven, IsSilentWithoutAnEventTimer) {
    verifies<req::CO_PDO_018>();
    begin();
    EXPECT_TRUE(own_queue.empty());
    EXPECT_EQ(service.next_deadline(), never);
    device->objects().write(0x2001, 1, 0x11);
    service.value_changed(0x2001, 1, now);
    service.advance(now);
    EXPECT_TRUE(own_queue.empty());
}

TEST_F(TimeDriven, IsSentOnEnteringOperationalAndEachEventTimeFromThen) {
    verifies<req::CO_PDO_018, req::CO_PDO_017>();
    device->objects().write(0x1800, 5, 100);  // ms
    begin();
    EXPECT_EQ(host::format_frame(own_queue.pop()), "185#0000");
    EXPECT_EQ(service.next_deadline(), now + milliseconds(100));
    device->objects().write(0x2001, 1, 0x11);
    service.value_changed(0x2001, 1, now);
    service.advance(now);
    EXPECT_TRUE(own_queue.empty());  // a change is no event
    now = now + milliseconds(100);
    service.advance(now);
    EXPECT_EQ(host::format_frame(own_queue.pop()), "185#1100");
    EXPECT_EQ(service.next_deadline(), now + milliseconds(100));
    Frame request = data_frame(0x185, 2);
    request.remote = true;
    service.answer(request, now);
    service.advance(now);
    EXPECT_EQ(host::format_frame(own_queue.pop()), "185#1100");
}

TEST_F(TimeDriven, AChangeIsAnEventOfType0Alone) {
    verifies<req::CO_PDO_018, req::CO_PDO_013>();
    // 2001h:1 in TPDO1, of type 254, and in TPDO2, of type 0
    device->objects().write(0x1801, 2, 0);
    device->objects().write(0x1A01, 0, 1);
    device->objects().write(0x1A01, 1, 0x20010108);
    begin();
    device->objects().write(0x2001, 1, 0x11);
    service.value_changed(0x2001, 1, now);
    service.advance(now);
    EXPECT_TRUE(own_queue.empty());
    service.sync(0);
    EXPECT_EQ(host::format_frame(own_queue.pop()), "285#11");
    service.advance(now);
    EXPECT_TRUE(own_queue.empty());
}

TEST_F(TimeDriven, TheInhibitTimeMovesTheDeadline) {
    verifies<req::CO_PDO_017>();
    device->objects().write(0x1800, 5, 5);   // 5 ms
    device->objects().write(0x1800, 3, 80);  // 8 ms
    begin();
    EXPECT_EQ(service.next_deadline(), now + milliseconds(8));
}

TEST_F(TimeDriven, WithoutTpdosThereIsNothingToDo) {
    verifies<req::CO_PDO_027>();
    TransmitPdos unused{{}, {}, device->objects(), own_queue, TpdoTrigger::value_change};
    unused.start(now);  // before reset() no TPDO is known
    unused.sync(0);
    unused.value_changed(0x2001, 1, now);
    unused.advance(now);
    EXPECT_TRUE(own_queue.empty());
    EXPECT_EQ(unused.next_deadline(), never);
}

TEST_F(Tpdo, TheInhibitTimeKeepsTransmissionsApart) {
    verifies<req::CO_PDO_017>();
    set_inhibit_time("6400");  // 100 * 100 us = 10 ms
    start();
    talk(*this, {
                    {"605#2F01200111000000", {"585#6001200100000000"}},
                    {"605#2F01200122000000", {"585#6001200100000000"}},
                });
    EXPECT_EQ(pass(30), (Frames{"10:185#2200"}));  // the values of then, once
    EXPECT_EQ(send("605#2F01200133000000"), (Frames{"185#3300", "585#6001200100000000"}));
    pass(9);
    EXPECT_EQ(send("605#2F01200144000000"), (Frames{"585#6001200100000000"}));
    EXPECT_EQ(pass(5), (Frames{"1:185#4400"}));
}

TEST_F(Tpdo, AnInhibitTimeEndsWhenOperationalIsLeft) {
    verifies<req::CO_PDO_017, req::CO_PDO_018>();
    set_inhibit_time("6400");  // 10 ms
    start();
    EXPECT_TRUE(send("000#8005").empty());
    EXPECT_TRUE(pass(4).empty());
    EXPECT_EQ(send("000#0105"), (Frames{"185#0000"}));
}

TEST_F(Tpdo, TheEventTimerSendsWithoutAChange) {
    verifies<req::CO_PDO_017>();
    send("605#2B00180519000000");  // 25 ms
    start();
    EXPECT_EQ(pass(80), (Frames{"25:185#0000", "50:185#0000", "75:185#0000"}));
    // an event begins the interval anew
    EXPECT_EQ(send("605#2F01200111000000"), (Frames{"185#1100", "585#6001200100000000"}));
    EXPECT_EQ(pass(30), (Frames{"25:185#1100"}));
}

TEST_F(Tpdo, TheEventTimerKeepsItsStepWhenItIsServedLate) {
    verifies<req::CO_PDO_017>();
    send("605#2B0018050A000000");  // 10 ms
    start();
    now = now + milliseconds(13);
    device->advance(now);
    EXPECT_EQ(sent(), (Frames{"185#0000"}));
    EXPECT_EQ(pass(10), (Frames{"7:185#0000"}));
    pass(7);
    now = now + milliseconds(100);  // what was missed is not made up for
    device->advance(now);
    EXPECT_EQ(sent(), (Frames{"185#0000"}));
    device->advance(now);
    EXPECT_TRUE(sent().empty());
}

TEST_F(Tpdo, TheInhibitTimeOutlastsAShorterEventTimer) {
    verifies<req::CO_PDO_017>();
    send("605#2B00180505000000");  // 5 ms
    set_inhibit_time("5000");      // 8 ms
    start();
    EXPECT_EQ(pass(24), (Frames{"8:185#0000", "16:185#0000", "24:185#0000"}));
}

TEST_F(Tpdo, ANewEventTimerRunsFromItsWrite) {
    verifies<req::CO_PDO_025>();
    start();
    EXPECT_TRUE(pass(100).empty());
    EXPECT_EQ(send("605#2B0018050A000000"), (Frames{"585#6000180500000000"}));
    EXPECT_EQ(pass(15), (Frames{"10:185#0000"}));
    EXPECT_EQ(send("605#2B00180500000000"), (Frames{"585#6000180500000000"}));
    EXPECT_TRUE(pass(100).empty());
}

// -- Types 0 to 240 ---------------------------------------------------------------------------------------------------

TEST_F(Tpdo, Type0IsSentAtTheSyncAfterAChange) {
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
                    {"605#2F01200222000000", {"585#6001200200000000"}},  // no change
                    {"080#", {}},
                    {"605#2F01200200000000", {"585#6001200200000000"}},
                    {"080#", {"185#1100"}},
                });
}

TEST_F(Tpdo, TypeNIsSentAtEachNthSync) {
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
                    {"000#0105", {}},  // counted anew
                    {"080#", {}},
                    {"080#", {}},
                    {"080#", {"185#1100"}},
                });
}

TEST_F(Tpdo, Type1And240AreTheEndsOfTheRange) {
    verifies<req::CO_PDO_014>();
    set_type("F0");
    send("000#0105");
    for (int sync = 1; sync <= 480; ++sync) {
        const Frames expected = (sync % 240 == 0) ? Frames{"185#0000", "285#0000000000000000"}
                                                  : Frames{"285#0000000000000000"};  // TPDO2 is of type 1
        EXPECT_EQ(send("080#"), expected) << sync;
    }
}

TEST_F(Tpdo, TheStartValueSaysWhichSyncIsTheFirst) {
    verifies<req::CO_PDO_019, req::CO_SYNC_001>();
    silence_tpdo2();
    talk(*this, {
                    {"605#2F1910000A000000", {"585#6019100000000000"}},  // 1019h: counter 1 … 10
                    {"605#2300180185010080", {"585#6000180100000000"}},
                    {"605#2F00180202000000", {"585#6000180200000000"}},  // each second SYNC
                    {"605#2F00180604000000", {"585#6000180600000000"}},  // from counter 4 on
                    {"605#2300180185010000", {"585#6000180100000000"}},
                    {"000#0105", {}},
                    {"080#02", {}},
                    {"080#03", {}},
                    {"080#04", {}},  // the first
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

TEST_F(Tpdo, WithoutAStartValueAnySyncIsTheFirst) {
    verifies<req::CO_PDO_019, req::CO_PDO_014>();
    send("605#2F1910000A000000");  // 1019h: counter 1 … 10
    EXPECT_EQ(send("000#0105"), (Frames{"185#0000"}));
    EXPECT_EQ(send("080#07"), (Frames{"285#0000000000000000"}));  // TPDO2 is of type 1
    EXPECT_EQ(send("080#08"), (Frames{"285#0000000000000000"}));
}

TEST_F(Tpdo, WithoutACounterTheStartValueHasNoEffect) {
    verifies<req::CO_PDO_019>();
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

TEST_F(Tpdo, AProducedSyncAndItsCounterWorkInTheNodeItself) {
    verifies<req::CO_SYNC_005, req::CO_PDO_019>();
    silence_tpdo2();
    talk(*this, {
                    {"605#2F19100003000000", {"585#6019100000000000"}},  // counter 1 … 3
                    {"605#2300180185010080", {"585#6000180100000000"}},
                    {"605#2F00180203000000", {"585#6000180200000000"}},
                    {"605#2F00180602000000", {"585#6000180600000000"}},
                    {"605#2300180185010000", {"585#6000180100000000"}},
                    {"000#0105", {}},
                    {"605#2306100010270000", {"585#6006100000000000"}},  // 10 ms
                    {"605#2305100080000040", {"585#6005100000000000"}},
                });
    EXPECT_EQ(pass(70), (Frames{"10:080#01", "20:080#02", "30:080#03", "40:080#01", "40:185#0000", "50:080#02",
                                "60:080#03", "70:080#01", "70:185#0000"}));
}

TEST_F(Tpdo, AProducedSyncWithoutACounterIsTheFirstWhateverTheStartValue) {
    verifies<req::CO_SYNC_005, req::CO_PDO_019>();
    silence_tpdo2();
    talk(*this, {
                    {"605#2300180185010080", {"585#6000180100000000"}},
                    {"605#2F00180201000000", {"585#6000180200000000"}},
                    {"605#2F00180604000000", {"585#6000180600000000"}},
                    {"605#2300180185010000", {"585#6000180100000000"}},
                    {"000#0105", {}},
                    {"605#2306100010270000", {"585#6006100000000000"}},  // 10 ms
                    {"605#2305100080000040", {"585#6005100000000000"}},
                });
    EXPECT_EQ(pass(20), (Frames{"10:080#", "10:185#0000", "20:080#", "20:185#0000"}));
}

TEST_F(Tpdo, AnEventTimerSendsNoSynchronousPdo) {
    verifies<req::CO_PDO_014, req::CO_PDO_013>();
    send("000#0105");
    EXPECT_EQ(send("605#2B01180564000000"), (Frames{"585#6001180500000000"}));  // TPDO2, type 1: 100 ms
    EXPECT_TRUE(pass(1000).empty());
    EXPECT_EQ(send("080#"), (Frames{"285#0000000000000000"}));
}

TEST_F(Tpdo, ASyncOfWrongLengthTriggersNothing) {
    verifies<req::CO_SYNC_002>();
    start();
    EXPECT_EQ(send("080#01"), (Frames{"085#4082110100000000"}));  // 8240h
    EXPECT_EQ(send("080#"), (Frames{"085#0000000100000000", "285#0000000000000000"}));
}

TEST_F(Tpdo, AtASyncTpdosTakeTheirValuesBeforeRpdosSetTheirs) {
    verifies<req::CO_PDO_029>();
    silence_tpdo2();
    // 2207h in RPDO3 and in TPDO3, both of type 1
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

TEST_F(Tpdo, Type253IsSentOnRequestAlone) {
    verifies<req::CO_PDO_016, req::CO_T_TRANSMISSION_TYPE>();
    silence_tpdo2();
    set_type("FD");
    send("605#2B0018050A000000");  // no event timer in this type
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

TEST_F(Tpdo, Type252IsSentAtNoSync) {
    verifies<req::CO_PDO_016, req::CO_T_TRANSMISSION_TYPE>();
    silence_tpdo2();
    set_type("FC");
    send("000#0105");
    for (int syncs = 0; syncs < 300; ++syncs) {  // 252 of them, and more
        EXPECT_TRUE(send("080#").empty()) << syncs;
    }
}

TEST_F(Tpdo, Type252GivesTheValuesOfTheLastSync) {
    verifies<req::CO_PDO_016, req::CO_T_TRANSMISSION_TYPE>();
    silence_tpdo2();
    set_type("FC");
    talk(*this, {
                    {"000#0105", {}},
                    {"185#R2", {}},  // no SYNC yet
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

TEST_F(Tpdo, SynchronousTypesAnswerWithTheValuesOfTheLastSync) {
    verifies<req::CO_PDO_016>();
    silence_tpdo2();
    for (const char* type : {"00", "05"}) {
        power_on();
        silence_tpdo2();
        set_type(type);
        talk(*this, {
                        {"000#0105", {}},
                        {"080#", {}},
                        {"605#2F01200111000000", {"585#6001200100000000"}},
                        {"185#R2", {"185#0000"}},
                    });
    }
}

TEST_F(Tpdo, EventDrivenTypesAnswerAfterTheInhibitTime) {
    verifies<req::CO_PDO_016>();
    start();
    EXPECT_EQ(send("185#R2"), (Frames{"185#0000"}));
    send("000#8005");
    set_inhibit_time("6400");  // 10 ms
    start();
    EXPECT_TRUE(send("185#R2").empty());
    EXPECT_EQ(pass(30), (Frames{"10:185#0000"}));
    EXPECT_EQ(send("185#R2"), (Frames{"185#0000"}));
}

TEST_F(Tpdo, Bit30ForbidsRequests) {
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

TEST_F(Tpdo, OnlyItsElevenBitIdentifierAsksForIt) {
    verifies<req::CO_PDO_016, req::CO_PDO_006, req::CO_FRAME_001>();
    start();
    talk(*this, {
                    {"00000185#R2", {}},
                    {"184#R2", {}},
                    {"385#R2", {}},  // TPDO3 is not valid
                    {"185#1122", {}},
                });
}

// -- Parameters in operational ----------------------------------------------------------------------------------------

TEST_F(Tpdo, Bit31SwitchesItOffAndOnAgain) {
    verifies<req::CO_PDO_006, req::CO_PDO_025>();
    start();
    talk(*this, {
                    {"605#2300180185010080", {"585#6000180100000000"}},
                    {"605#2F01200111000000", {"585#6001200100000000"}},
                    {"185#R2", {}},
                    {"605#2300180195010000", {"195#1100", "585#6000180100000000"}},  // on 195h
                    {"605#2F01200122000000", {"195#2200", "585#6001200100000000"}},
                    {"605#2300180195010080", {"585#6000180100000000"}},
                    {"605#2F001802FD000000", {"585#6000180200000000"}},
                    {"605#2300180185010000", {"585#6000180100000000"}},
                    {"605#2F001802FF000000", {"185#2200", "585#6000180200000000"}},  // another type
                });
}

TEST_F(Tpdo, WithNothingMappedNothingIsSent) {
    verifies<req::CO_PDO_028>();
    talk(*this, {
                    {"605#2302180185030000", {"585#6002180100000000"}},  // TPDO3 valid, 1A02h:0 = 0
                    {"000#0105", {"185#0000"}},
                    {"385#R8", {}},
                });
}

TEST_F(Tpdo, BitsArePackedFromTheLeastSignificantOfTheFirstByte) {
    verifies<req::CO_PDO_028>();
    // 2003h:1, 2003h:2 (bits 0, 1), 2101h:1 (2 … 17), 2003h:3 (18), 2001h:3 (19 … 26)
    map_tpdo3({"01010320", "01020320", "10010121", "01030320", "08030120"});
    send("605#2B01210134120000");  // 1234h << 2 = 48D0h
    send("605#2F03200201000000");  // bit 1: 2h
    send("605#2F03200301000000");  // bit 18: 40000h
    send("605#2F012003A5000000");  // A5h << 19 = 5280000h
    // 2h + 48D0h + 40000h + 5280000h = 52C48D2h
    EXPECT_EQ(send("000#0105"), (Frames{"185#0000", "385#D2482C05"}));
    EXPECT_EQ(send("605#2F03200301000000"), (Frames{"585#6003200300000000"}));
    EXPECT_EQ(send("605#2F03200300000000"), (Frames{"385#D2482805", "585#6003200300000000"}));
}

TEST_F(Tpdo, AllSixtyFourBitsCanBeSent) {
    verifies<req::CO_PDO_028>();
    map_tpdo3({"40000622"});  // 2206h: UNSIGNED64
    send("605#2106220008000000");
    send("605#000123456789ABCD");
    send("605#1DEF000000000000");
    EXPECT_EQ(send("000#0105"), (Frames{"185#0000", "385#0123456789ABCDEF"}));
}

}  // namespace canproof::test
