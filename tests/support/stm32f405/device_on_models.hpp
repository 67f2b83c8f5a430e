// SPDX-License-Identifier: Apache-2.0
// A complete device with its drivers: the CAN-CBX-AO412 on models of the peripherals bxCAN, flash, timers and watchdog,
// and of the RAM.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <utility>

#include "devices/cbx-ao412/firmware/cbx_ao412.hpp"
#include "target/stm32f405/device_loop.hpp"
#include "target/stm32f405/parameter_journal.hpp"
#include "tests/support/stm32f405/bxcan_model.hpp"
#include "tests/support/stm32f405/capture_model.hpp"
#include "tests/support/stm32f405/clock_model.hpp"
#include "tests/support/stm32f405/flash_model.hpp"
#include "tests/support/stm32f405/ram_model.hpp"
#include "tests/support/stm32f405/sealed_flash.hpp"
#include "tests/support/stm32f405/watchdog_model.hpp"

namespace canproof::test {

/// A board whose rotary switches select node 3 at 1 Mbit/s.
struct TestBoard {
    using Inputs = cbx_ao412::Inputs;
    using Outputs = cbx_ao412::Outputs;
    void read(Inputs& inputs) {
        inputs.switch_low = 3;
        inputs.switch_baud = 0;
        if (const auto act = std::exchange(on_read, nullptr)) {
            act();
        }
    }
    void drive(const Outputs& outputs) {
        driven = outputs;
        ++drives;
    }
    Outputs driven{};
    std::size_t drives{0};
    std::function<void()> on_read{};  ///< called once, when the device reads its inputs for the next time
};

/// The models of the microcontroller: peripherals, and the RAM and the flash image that the self-tests check.
struct Chips {
    BxcanModel can;
    FlashModel flash;
    WatchdogModel watchdog;
    PlainModel<stm32f405::TimerRegisters> timer;
    CaptureModel capture;
    RamModel ram{64};
    RamModel guard{8};
    SealedFlash image{72, 200};
};

/// The device with its drivers, powered on.
struct Unit {
    Chips& chips;
    stm32f405::Flash flash{chips.flash.registers(), 1000};
    stm32f405::JournalRam<1024> ram{};
    stm32f405::ParameterJournal memory{flash, chips.flash.sectors(), MutableBytes{ram.bytes},
                                       Slots<std::uint32_t>{ram.changed}};
    TransmitQueue queue{};
    cbx_ao412::Device device{memory, queue, cbx_ao412::FactoryData{}};
    TestBoard board{};
    stm32f405::Bxcan can{chips.can.registers(), 40000000};
    stm32f405::TimeBase time{chips.timer.registers(), 80};
    stm32f405::Watchdog watchdog{chips.watchdog.registers(), 1000};
    stm32f405::SelfTests tests{
        {chips.image.vectors(), chips.image.image(), {chips.ram.words(), 0, 0}, chips.guard.words()},
        chips.capture.registers(),
        80};
    stm32f405::DeviceLoop<cbx_ao412::Device, TestBoard> loop{device, queue, board, can, time, watchdog, tests};

    /// `on_first_read`: called when the loop reads the inputs for the power-on of the device.
    explicit Unit(Chips& around, bool may_join = true, std::function<void()> on_first_read = {}) : chips{around} {
        board.on_read = std::move(on_first_read);
        memory.open();
        EXPECT_TRUE(memory.prepare());
        loop.power_on(may_join);
    }
    /// Runs passes of the main loop, of 100 us each. Returns all frames that are sent during them.
    std::vector<Frame> run(std::uint32_t passes) {
        std::vector<Frame> sent;
        for (std::uint32_t i = 0; i < passes; ++i) {
            chips.timer.at(0x24) += 100;
            chips.capture.pass(100);
            can.drain();  // the receive interrupt would do this work
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

}  // namespace canproof::test
