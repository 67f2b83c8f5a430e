// SPDX-License-Identifier: Apache-2.0
// A complete device on the drivers: the CAN-CBX-AO412 with a model of bxCAN and parameters in a model of the flash.
#include "target/stm32f405/device_loop.hpp"

#include <gmock/gmock.h>

#include "tests/support/changed_time.hpp"
#include "tests/support/stm32f405/device_on_models.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using testing::IsEmpty;

}  // namespace

TEST(DeviceLoop, DeviceBootsAndAnswersAnSdoRequest) {
    verifies<req::CO_CAN_001, req::CO_CAN_004, req::CO_CAN_006>();
    Chips chips;
    Unit unit{chips};
    const auto boot = unit.run(5);
    ASSERT_EQ(boot.size(), 1U);
    EXPECT_EQ(boot[0].id, 0x703U);
    EXPECT_EQ(boot[0].length, 1U);
    // CAN-CBX-AO412 manual, 7.9.2: the device type is 00080191h.
    const auto answer = unit.ask(0x603, {0x40, 0x00, 0x10, 0x00, 0, 0, 0, 0});
    ASSERT_EQ(answer.size(), 1U);
    EXPECT_EQ(answer[0].id, 0x583U);
    const std::array<std::uint8_t, 8> expected{0x43, 0x00, 0x10, 0x00, 0x91, 0x01, 0x08, 0x00};
    EXPECT_EQ(answer[0].data, expected);
    EXPECT_THAT(chips.can.faults(), IsEmpty());
}

TEST(DeviceLoop, DeviceKeepsItsParametersInFlash) {
    verifies<req::CO_FLASH_002>();
    Chips chips;
    {
        Unit unit{chips};
        unit.run(5);
        unit.ask(0x603, {0x2B, 0x17, 0x10, 0x00, 0xF4, 0x01, 0, 0});  // 1017h producer heartbeat time: 500 ms
        const auto saved = unit.ask(0x603, {0x23, 0x10, 0x10, 0x01, 's', 'a', 'v', 'e'});  // 1010h store parameters
        ASSERT_EQ(saved.size(), 1U);
        EXPECT_EQ(saved[0].data[0], 0x60);
    }
    chips.timer.at(0x24) = 0;
    Unit unit{chips};
    const auto sent = unit.run(5100);  // in 510 ms: the boot-up message and one heartbeat, at 500 ms
    ASSERT_EQ(sent.size(), 2U);
    EXPECT_EQ(sent[1].id, 0x703U);
    EXPECT_EQ(sent[1].data[0], 0x7F);
    EXPECT_THAT(chips.flash.faults(), IsEmpty());
}

TEST(DeviceLoop, WatchdogRunsBeforeTheDeviceIsPoweredOn) {
    verifies<req::CO_WATCHDOG_001>();
    Chips chips;
    EXPECT_FALSE(chips.watchdog.is_running());
    bool runs = false;
    Unit unit{chips, true, [&] { runs = chips.watchdog.is_running(); }};  // the inputs that the device gets at power-on
    EXPECT_TRUE(runs);
}

TEST(DeviceLoop, DeviceRunsWithAWatchdogThatDoesNotConfirmItsPeriod) {
    verifies<req::CO_WATCHDOG_003>();
    Chips chips;
    chips.watchdog.stay_updating(true);
    Unit unit{chips};
    EXPECT_TRUE(chips.watchdog.is_running());
    EXPECT_EQ(unit.run(5).size(), 1U);  // the boot-up message
}

TEST(DeviceLoop, LoopRefreshesTheWatchdogOncePerPass) {
    verifies<req::CO_WATCHDOG_002>();
    Chips chips;
    Unit unit{chips};
    const std::size_t before = chips.watchdog.refreshes();
    unit.run(20000);  // 20,000 steps are 2 s
    EXPECT_EQ(chips.watchdog.refreshes() - before, 20000U);
    EXPECT_FALSE(chips.watchdog.has_bitten());
    chips.watchdog.pass(1001);
    EXPECT_TRUE(chips.watchdog.has_bitten());
}

TEST(DeviceLoop, InputsAreSampledAlthoughABitOfTheNextSampleTimeHasFlipped) {
    verifies<req::CO_SELF_020>();
    Chips chips;
    Unit unit{chips};
    unit.run(5);
    std::uint64_t next = 0;
    unit.board.on_read = [&] { next = (unit.time.now() + milliseconds(1)).us; };
    while (next == 0) {
        unit.run(1);
    }
    ASSERT_EQ(move_far_ahead(unit.loop, Instant{next}), 1U);
    bool reads = false;
    unit.board.on_read = [&] { reads = true; };
    unit.run(20);
    EXPECT_TRUE(reads);
}

TEST(DeviceLoop, DeviceStaysOffTheBusWithAWrongClock) {
    verifies<req::CO_CLOCK_005>();
    Chips chips;
    Unit unit{chips, false};
    EXPECT_THAT(unit.run(3000), IsEmpty());
    EXPECT_FALSE(unit.can.is_on_bus());
    EXPECT_EQ(unit.can.bit_rate(), 0U);
}

TEST(DeviceLoop, LostFrameIsReportedAsCanOverrunForOneSecond) {
    verifies<req::CO_CAN_005, req::CO_EMCY_016>();
    Chips chips;
    Unit unit{chips};
    unit.run(5);
    for (int i = 0; i < 4; ++i) {
        chips.can.receive(data_frame(0x101, 0));
    }
    const auto sent = unit.run(9990);
    ASSERT_EQ(sent.size(), 1U);
    EXPECT_EQ(sent[0].id, 0x083U);
    EXPECT_EQ(sent[0].data[0] | sent[0].data[1] << 8, 0x8110);  // CiA 301, Table 26: error code 8110h, CAN overrun
    const auto cured = unit.run(100);
    ASSERT_EQ(cured.size(), 1U);
    EXPECT_EQ(cured[0].id, 0x083U);
    EXPECT_EQ(cured[0].data[0] | cured[0].data[1] << 8, 0x0000);
}

TEST(DeviceLoop, DeviceRecoversFromBusOff) {
    verifies<req::CO_CAN_008, req::CO_EMCY_017, req::CO_EMCY_031>();
    Chips chips;
    Unit unit{chips};
    unit.run(5);
    chips.can.count_errors(256, 0);
    EXPECT_THAT(unit.run(1100), IsEmpty());  // 1100 steps are 110 ms
    chips.can.pass_recessive(128);
    const auto sent = unit.run(10);
    ASSERT_FALSE(sent.empty());
    EXPECT_EQ(sent[0].id, 0x083U);
    EXPECT_FALSE(unit.ask(0x603, {0x40, 0x00, 0x10, 0x00, 0, 0, 0, 0}).empty());
}

/// The usual way to bus-off: a disturbed bus carries nothing, so the message of error passive waits in a mailbox.
TEST(DeviceLoop, EmergencyMessageInAMailboxIsSentAfterTheBusOff) {
    verifies<req::CO_CAN_018, req::CO_EMCY_035>();
    Chips chips;
    Unit unit{chips};
    unit.run(5);
    chips.can.hold_dominant(true);
    chips.can.count_errors(200, 0);
    EXPECT_THAT(unit.run(20), IsEmpty());
    chips.can.count_errors(256, 0);
    EXPECT_THAT(unit.run(20), IsEmpty());
    chips.can.hold_dominant(false);
    EXPECT_THAT(unit.run(1100), IsEmpty());  // 1100 steps are 110 ms
    chips.can.pass_recessive(128);
    std::vector<int> codes;
    for (const Frame& frame : unit.run(20)) {
        EXPECT_EQ(frame.id, 0x083U);
        codes.push_back(frame.data[0] | frame.data[1] << 8);
    }
    // error passive, recovered from bus-off, end of error passive
    EXPECT_THAT(codes, testing::ElementsAre(0x8120, 0x8140, 0x0000));
}

}  // namespace canproof::test
