// SPDX-License-Identifier: Apache-2.0
// Tests the inhibit time and the event timer of transmit PDOs (CiA 301, 7.5.2.37), also on a device whose only event is
// the event timer.
#include "generated/canopen/requirements.hpp"
#include "tests/conformance/tpdo_cases.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

// -- A device whose only event is the event timer (AX130751, 3.2.15) --------------------------------------------------

namespace {

/// A fixture with only a TPDO service, which uses the dictionary of the conformance slave.
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

TEST_F(TimeDriven, TpdoWithoutAnEventTimerIsNotSent) {
    verifies<req::CO_PDO_049>();
    begin();
    EXPECT_TRUE(own_queue.empty());
    EXPECT_EQ(service.next_deadline(), never);
    device->objects().write(0x2001, 1, 0x11);
    service.value_changed(0x2001, 1, now);
    service.advance(now);
    EXPECT_TRUE(own_queue.empty());
}

TEST_F(TimeDriven, TpdoIsSentOnEnteringOperationalAndWheneverItsEventTimerExpires) {
    verifies<req::CO_PDO_049, req::CO_PDO_047>();
    device->objects().write(0x1800, 5, 100);  // 1800h:5 event timer of TPDO1: 100 ms
    begin();
    EXPECT_EQ(host::format_frame(own_queue.pop()), "185#0000");
    EXPECT_EQ(service.next_deadline(), now + milliseconds(100));
    device->objects().write(0x2001, 1, 0x11);
    service.value_changed(0x2001, 1, now);
    service.advance(now);
    EXPECT_TRUE(own_queue.empty());  // for this TPDO service, a change of a value is no event
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

TEST_F(TimeDriven, ChangeOfAValueTriggersATpdoOfType0Only) {
    verifies<req::CO_PDO_049, req::CO_PDO_013>();
    // 2001h:1 is mapped into TPDO1 (transmission type 254) and into TPDO2 (type 0)
    device->objects().write(0x1801, 2, 0);
    device->objects().write(0x1A01, 0, 1);
    device->objects().write(0x1A01, 1, 0x20010108);
    begin();
    device->objects().write(0x2001, 1, 0x11);
    service.value_changed(0x2001, 1, now);
    service.advance(now);
    EXPECT_TRUE(own_queue.empty());
    service.sync(0, false);
    EXPECT_EQ(host::format_frame(own_queue.pop()), "285#11");
    service.advance(now);
    EXPECT_TRUE(own_queue.empty());
}

TEST_F(TimeDriven, InhibitTimeLongerThanTheEventTimerSetsTheNextDeadline) {
    verifies<req::CO_PDO_017, req::CO_PDO_047>();
    device->objects().write(0x1800, 5, 5);   // 1800h:5 event timer of TPDO1: 5 ms
    device->objects().write(0x1800, 3, 80);  // 1800h:3 inhibit time of TPDO1: 8 ms
    begin();
    EXPECT_EQ(service.next_deadline(), now + milliseconds(8));
}

TEST_F(TimeDriven, TpdoServiceWithoutTpdosHasNoDeadline) {
    verifies<req::CO_PDO_027>();
    TransmitPdos unused{{}, {}, device->objects(), own_queue, TpdoTrigger::value_change};
    unused.start(now);  // before a call of reset(), the service has no TPDOs
    unused.sync(0, false);
    unused.value_changed(0x2001, 1, now);
    unused.advance(now);
    EXPECT_TRUE(own_queue.empty());
    EXPECT_EQ(unused.next_deadline(), never);
}

TEST_F(Tpdo, TpdosAreSentAtLeastTheInhibitTimeApart) {
    verifies<req::CO_PDO_017, req::CO_PDO_048>();
    set_inhibit_time("6400");  // 100 * 100 us = 10 ms
    start();
    talk(*this, {
                    {"605#2F01200111000000", {"585#6001200100000000"}},
                    {"605#2F01200122000000", {"585#6001200100000000"}},
                });
    EXPECT_EQ(pass(30), (Frames{"10:185#2200"}));  // only one TPDO, with the values at the end of the inhibit time
    EXPECT_EQ(send("605#2F01200133000000"), (Frames{"185#3300", "585#6001200100000000"}));
    pass(9);
    EXPECT_EQ(send("605#2F01200144000000"), (Frames{"585#6001200100000000"}));
    EXPECT_EQ(pass(5), (Frames{"1:185#4400"}));
}

TEST_F(Tpdo, InhibitTimeCountsFromALateTransmission) {
    verifies<req::CO_PDO_017>();
    set_inhibit_time("6400");  // 100 * 100 us = 10 ms
    start();
    EXPECT_EQ(send("605#2F01200111000000"), (Frames{"585#6001200100000000"}));
    now = now + milliseconds(14);  // 4 ms late
    device->advance(now);
    EXPECT_EQ(sent(), (Frames{"185#1100"}));
    EXPECT_EQ(send("605#2F01200122000000"), (Frames{"585#6001200100000000"}));
    EXPECT_TRUE(pass(9).empty());
    EXPECT_EQ(pass(1), (Frames{"1:185#2200"}));
}

TEST_F(Tpdo, InhibitTimeEndsWhenOperationalIsLeft) {
    verifies<req::CO_PDO_017, req::CO_PDO_018>();
    set_inhibit_time("6400");  // 100 * 100 us = 10 ms
    start();
    EXPECT_TRUE(send("000#8005").empty());
    EXPECT_TRUE(pass(4).empty());
    EXPECT_EQ(send("000#0105"), (Frames{"185#0000"}));
}

TEST_F(Tpdo, EventTimerSendsATpdoWithoutAChangeOfValue) {
    verifies<req::CO_PDO_047>();
    send("605#2B00180519000000");  // 1800h:5 event timer of TPDO1: 25 ms
    start();
    EXPECT_EQ(pass(80), (Frames{"25:185#0000", "50:185#0000", "75:185#0000"}));
    // a change of value restarts the event timer
    EXPECT_EQ(send("605#2F01200111000000"), (Frames{"185#1100", "585#6001200100000000"}));
    EXPECT_EQ(pass(30), (Frames{"25:185#1100"}));
}

TEST_F(Tpdo, AnsweredRemoteRequestRestartsTheTpdoEventTimer) {
    verifies<req::CO_PDO_016, req::CO_PDO_046, req::CO_PDO_047>();
    send("605#2B00180519000000");  // 1800h:5 event timer of TPDO1: 25 ms
    start();
    EXPECT_EQ(pass(10), Frames{});
    EXPECT_EQ(send("185#R2"), (Frames{"185#0000"}));
    EXPECT_EQ(pass(30), (Frames{"25:185#0000"}));
}

TEST_F(Tpdo, EventTimerSetsNoDeadlineOutsideOperational) {
    verifies<req::CO_PDO_047, req::CO_PDO_018>();
    send("605#2B00180519000000");  // 1800h:5 event timer of TPDO1: 25 ms
    start();
    EXPECT_EQ(device->next_deadline().us, (now + milliseconds(25)).us);
    send("000#8005");
    EXPECT_EQ(device->next_deadline().us, never.us);
}

TEST_F(Tpdo, SwitchedOffTpdoIsNotSentWhenOtherTpdosAreSent) {
    verifies<req::CO_PDO_006, req::CO_PDO_047>();
    send("605#2B00180519000000");  // 1800h:5 event timer of TPDO1: 25 ms
    send("605#2B01180505000000");  // 1801h:5 event timer of TPDO2: 5 ms
    send("605#2F011802FF000000");  // 1801h:2 transmission type of TPDO2: 255
    send("000#0105");
    EXPECT_EQ(send("605#2300180185010080"), (Frames{"585#6000180100000000"}));
    const Frames frames = pass(30);
    EXPECT_EQ(frames.size(), 6U);
    for (const std::string& frame : frames) {
        EXPECT_NE(frame.find(":285#"), std::string::npos) << frame;
    }
}

TEST_F(Tpdo, SyncCountOfATpdoContinuesWhenItsEventTimerIsWritten) {
    verifies<req::CO_PDO_013, req::CO_PDO_025>();
    send("605#2301180185020080");  // TPDO2 is off
    send("605#2F00180202000000");  // transmission type 2: every second SYNC
    send("000#0105");
    EXPECT_EQ(send("080#"), Frames{});
    EXPECT_EQ(send("605#2B00180519000000"), (Frames{"585#6000180500000000"}));
    EXPECT_EQ(send("080#"), (Frames{"185#0000"}));
}

TEST_F(Tpdo, TpdoEventTimerKeepsItsPhaseWhenTheDeviceIsAdvancedLate) {
    verifies<req::CO_PDO_047>();
    send("605#2B0018050A000000");  // 1800h:5 event timer of TPDO1: 10 ms
    start();
    now = now + milliseconds(13);
    device->advance(now);
    EXPECT_EQ(sent(), (Frames{"185#0000"}));
    EXPECT_EQ(pass(10), (Frames{"7:185#0000"}));
    pass(7);
    now = now + milliseconds(100);  // missed transmissions are not sent later
    device->advance(now);
    EXPECT_EQ(sent(), (Frames{"185#0000"}));
    device->advance(now);
    EXPECT_TRUE(sent().empty());
}

TEST_F(Tpdo, TpdoPeriodIsTheInhibitTimeWhenTheEventTimerIsShorter) {
    verifies<req::CO_PDO_017, req::CO_PDO_047>();
    send("605#2B00180505000000");  // 1800h:5 event timer of TPDO1: 5 ms
    set_inhibit_time("5000");      // 80 * 100 us = 8 ms
    start();
    EXPECT_EQ(pass(24), (Frames{"8:185#0000", "16:185#0000", "24:185#0000"}));
}

TEST_F(Tpdo, NewTpdoEventTimerRunsFromTheTimeOfItsWrite) {
    verifies<req::CO_PDO_051>();
    start();
    EXPECT_TRUE(pass(100).empty());
    EXPECT_EQ(send("605#2B0018050A000000"), (Frames{"585#6000180500000000"}));
    EXPECT_EQ(pass(15), (Frames{"10:185#0000"}));
    EXPECT_EQ(send("605#2B00180500000000"), (Frames{"585#6000180500000000"}));
    EXPECT_TRUE(pass(100).empty());
}

}  // namespace canproof::test
