// SPDX-License-Identifier: Apache-2.0
// A complete device on the drivers: the CAN-CBX-AO412 with a model of bxCAN and parameters in a model of the flash.
#include "target/stm32f405/device_loop.hpp"

#include <gmock/gmock.h>

#include "devices/cbx-ao412/firmware/cbx_ao412.hpp"
#include "target/stm32f405/parameter_journal.hpp"
#include "tests/support/stm32f405/bxcan_model.hpp"
#include "tests/support/stm32f405/clock_model.hpp"
#include "tests/support/stm32f405/flash_model.hpp"
#include "tests/support/stm32f405/watchdog_model.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace stm32f405;
using testing::IsEmpty;

/// Node 3 at 1 Mbit/s, selected by its switches.
struct TestBoard {
    using Inputs = cbx_ao412::Inputs;
    using Outputs = cbx_ao412::Outputs;
    void read(Inputs& inputs) const {
        inputs.switch_low = 3;
        inputs.switch_baud = 0;
    }
    void drive(const Outputs& outputs) { driven = outputs; }
    Outputs driven{};
};

struct Chips {
    BxcanModel can;
    FlashModel flash;
    WatchdogModel watchdog;
    PlainModel<TimerRegisters> timer;
};

struct Unit {
    Chips& chips;
    Flash flash{chips.flash.registers(), 1000};
    JournalRam<1024> ram{};
    ParameterJournal memory{flash, chips.flash.sectors(), MutableBytes{ram.bytes}, Slots<std::uint32_t>{ram.changed}};
    TransmitQueue queue{};
    cbx_ao412::Device device{memory, queue, cbx_ao412::FactoryData{}};
    TestBoard board{};
    Bxcan can{chips.can.registers(), 40000000};
    TimeBase time{chips.timer.registers(), 80};
    Watchdog watchdog{chips.watchdog.registers(), 1000};
    DeviceLoop<cbx_ao412::Device, TestBoard> loop{device, queue, board, can, time, watchdog};

    explicit Unit(Chips& around, bool may_join = true) : chips{around} {
        memory.open();
        EXPECT_TRUE(memory.prepare());
        loop.power_on(may_join);
    }
    /// Runs passes of 100 us. Returns all frames that are sent during them.
    std::vector<Frame> run(std::uint32_t passes) {
        std::vector<Frame> sent;
        for (std::uint32_t i = 0; i < passes; ++i) {
            chips.timer.at(0x24) += 100;
            can.drain();  // as the interrupt does
            loop.pass();
            chips.watchdog.pass(0.1);
            if (const auto frame = chips.can.transmit()) {
                sent.push_back(*frame);
            }
        }
        return sent;
    }
    std::vector<Frame> ask(std::uint32_t id, std::initializer_list<std::uint8_t> bytes) {
        Frame frame = data_frame(id, static_cast<std::uint8_t>(bytes.size()));
        std::copy(bytes.begin(), bytes.end(), frame.data.begin());
        EXPECT_EQ(chips.can.receive(frame), BxcanModel::Taken::kept);
        return run(5);
    }
};

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
    const auto sent = unit.run(5100);  // 510 ms: boot-up message and one heartbeat
    ASSERT_EQ(sent.size(), 2U);
    EXPECT_EQ(sent[1].id, 0x703U);
    EXPECT_EQ(sent[1].data[0], 0x7F);
    EXPECT_THAT(chips.flash.faults(), IsEmpty());
}

TEST(DeviceLoop, LoopRefreshesTheWatchdogOncePerPass) {
    verifies<req::CO_WATCHDOG_001>();
    Chips chips;
    Unit unit{chips};
    const std::size_t before = chips.watchdog.refreshes();
    unit.run(20000);  // 2 s
    EXPECT_EQ(chips.watchdog.refreshes() - before, 20000U);
    EXPECT_FALSE(chips.watchdog.has_bitten());
    chips.watchdog.pass(1001);
    EXPECT_TRUE(chips.watchdog.has_bitten());
}

TEST(DeviceLoop, DeviceStaysOffTheBusWithAWrongClock) {
    verifies<req::CO_CLOCK_001>();
    Chips chips;
    Unit unit{chips, false};
    EXPECT_THAT(unit.run(3000), IsEmpty());
    EXPECT_FALSE(unit.can.is_on_bus());
    EXPECT_EQ(unit.can.bit_rate(), 0U);
}

TEST(DeviceLoop, LostFrameIsReportedForASecond) {
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
    EXPECT_EQ(sent[0].data[0] | sent[0].data[1] << 8, 0x8110);  // CiA 301, Table 26: CAN overrun
    const auto cured = unit.run(100);
    ASSERT_EQ(cured.size(), 1U);
    EXPECT_EQ(cured[0].id, 0x083U);
    EXPECT_EQ(cured[0].data[0] | cured[0].data[1] << 8, 0x0000);
}

TEST(DeviceLoop, DeviceRecoversFromBusOff) {
    verifies<req::CO_CAN_008, req::CO_EMCY_017>();
    Chips chips;
    Unit unit{chips};
    unit.run(5);
    chips.can.count_errors(256, 0);
    EXPECT_THAT(unit.run(1100), IsEmpty());  // 110 ms
    chips.can.pass_recessive(128);
    const auto sent = unit.run(10);
    ASSERT_FALSE(sent.empty());
    EXPECT_EQ(sent[0].id, 0x083U);
    EXPECT_FALSE(unit.ask(0x603, {0x40, 0x00, 0x10, 0x00, 0, 0, 0, 0}).empty());
}

}  // namespace canproof::test
