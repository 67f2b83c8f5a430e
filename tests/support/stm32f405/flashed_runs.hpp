// SPDX-License-Identifier: Apache-2.0
// Runs of a flashed device: its start, its frames, and its end after a failed self-test. The tests in
// tests/target/flashed/ call these functions for each device.
#pragma once

#include <gmock/gmock.h>

#include <algorithm>
#include <memory>

#include "tests/support/settings_watch.hpp"
#include "tests/support/stm32f405/core_model.hpp"
#include "tests/support/stm32f405/flashed_bench.hpp"

namespace canproof::test {

constexpr std::uint32_t start_passes = 200;  ///< after these passes the node is on the bus

/// Returns whether a register belongs to the inputs of a board: the converter, or the levels of port B or C.
inline bool is_input(std::uintptr_t address) {
    return address - 0x40012000 < 0x308 || address == 0x40020410 || address == 0x40020810;
}

inline void expect_boot_up(const std::vector<Frame>& sent) {
    EXPECT_TRUE(std::any_of(sent.begin(), sent.end(), [](const Frame& frame) {
        return (frame.id & ~0x7FU) == 0x700U && frame.length == 1 && frame.data[0] == 0;
    }));
}

/// The image does not power its device on when it is damaged or the PLL gives no clock. An exception before that writes
/// no register.
inline void runs_that_do_not_start(const FlashedImage& image) {
    {
        FlashedBench bench{image};
        AccessLog log;
        image.failed();
        EXPECT_TRUE(log.take_writes().empty());
    }
    {
        FlashedBench bench{image};
        common_store().flash.turn(150, 3);
        EXPECT_FALSE(bench.run(10));
        common_store().flash.turn(150, 3);
        EXPECT_EQ(bench.passes(), 0U);
    }
    FlashedBench bench{image};
    bench.chip.clock.break_pll();
    EXPECT_FALSE(bench.run(10));
    EXPECT_EQ(bench.passes(), 0U);
}

/// Returns the signature of the program flow in the main loop, which calls this function from the start of a pass. The
/// loop lies further up on the stack: it begins with the addresses of device and queue, and the signature of a new pass
/// (FlowMonitor::start) follows them. AddressSanitizer would stop a search across variables of other functions.
[[gnu::noinline, gnu::no_sanitize_address]] inline void* flow_signature(const FlashedImage& image) {
    auto* word = static_cast<std::uintptr_t*>(__builtin_frame_address(0));
    while (word[0] != reinterpret_cast<std::uintptr_t>(image.device) ||
           word[1] != reinterpret_cast<std::uintptr_t>(image.queue)) {
        ++word;
    }
    auto* half = reinterpret_cast<std::uint32_t*>(word);
    while (*half != 0x811C9DC5U) {
        ++half;
    }
    return half;
}

/// With its crystal the device is on the bus; an exception ends that. Without the crystal it runs off the bus.
inline void runs_with_and_without_crystal(const FlashedImage& image) {
    {
        FlashedBench bench{image};
        EXPECT_TRUE(bench.run(2000));
        expect_boot_up(bench.take_sent());
        EXPECT_EQ(bench.chip.can.receive(data_frame(0x603, 8)), BxcanModel::Taken::kept);
        image.failed();
        EXPECT_EQ(bench.chip.can.receive(data_frame(0x603, 8)), BxcanModel::Taken::filtered);
        EXPECT_EQ(FlashedBench::take_record(), stm32f405::SelfTest::none);
    }
    FlashedBench bench{image};
    bench.chip.clock.break_crystal();
    EXPECT_TRUE(bench.run(2000));
    EXPECT_TRUE(bench.take_sent().empty());
    EXPECT_NE(bench.chip.can.receive(data_frame(0x603, 8)), BxcanModel::Taken::kept);
}

inline void receive(FlashedBench& bench, std::uint32_t id, const std::vector<std::uint8_t>& bytes) {
    Frame frame = data_frame(id, static_cast<std::uint8_t>(bytes.size()));
    std::copy(bytes.begin(), bytes.end(), frame.data.begin());
    EXPECT_EQ(bench.chip.can.receive(frame), BxcanModel::Taken::kept);
}

/// The device takes frames that come together in one pass or in several, goes on after a lost frame, and sends its
/// heartbeat (1017h) each 10 ms, which are 100 passes.
inline void run_with_frames(const FlashedImage& image, std::uint32_t node) {
    FlashedBench bench{image};
    bench.on_pass = [&bench, &image, node] {
        const std::uint32_t number = bench.passes();
        if (number == start_passes) {
            receive(bench, 0x600 + node, {0x2B, 0x17, 0x10, 0x00, 10, 0, 0, 0});
        }
        if (number > start_passes && number % 7 == 0 && number < 1000) {
            bench.chip.can.receive(data_frame(0x7E0, 0));
        }
        for (std::uint32_t more = 0; more < 11 && number == 1001; ++more) {
            bench.chip.can.receive(data_frame(0x7E0 + more, 0));
            image.received();
        }
        for (int more = 0; more < 5 && number == 1020; ++more) {  // a FIFO holds three frames
            bench.chip.can.receive(data_frame(0x7E0, 0));
        }
    };
    EXPECT_TRUE(bench.run(1200));
    const auto sent = bench.take_sent();
    expect_boot_up(sent);
    const auto is_of_node = [node](const Frame& frame) { return frame.id == 0x700 + node; };
    EXPECT_GE(std::count_if(sent.begin(), sent.end(), is_of_node), 1 + 9);
    EXPECT_EQ(FlashedBench::take_record(), stm32f405::SelfTest::none);
}

/// The device sends its boot-up message again after each reset by NMT (81h and 82h).
inline void run_with_resets(const FlashedImage& image, std::uint8_t node) {
    FlashedBench bench{image};
    bench.on_pass = [&bench, node] {
        const std::uint32_t number = bench.passes();
        if (number == start_passes || number == start_passes + 101) {
            receive(bench, 0x000, {static_cast<std::uint8_t>(number == start_passes ? 0x81 : 0x82), node});
        }
    };
    EXPECT_TRUE(bench.run(start_passes + 300));
    const auto sent = bench.take_sent();
    const auto is_boot_up = [node](const Frame& frame) { return frame.id == 0x700U + node && frame.data[0] == 0; };
    EXPECT_EQ(std::count_if(sent.begin(), sent.end(), is_boot_up), 3);
}

/// A bus that is full of other frames keeps the answers and heartbeats of the device in its queue until the queue is
/// full, and an emergency message waits for a place in the queue. They are sent when the bus is free again.
inline void run_with_busy_bus(const FlashedImage& image, std::uint32_t node) {
    FlashedBench bench{image};
    bench.on_pass = [&bench, node] {
        const std::uint32_t number = bench.passes();
        if (number == start_passes) {
            receive(bench, 0x600 + node, {0x2B, 0x17, 0x10, 0x00, 10, 0, 0, 0});
        }
        if (number == start_passes + 20) {  // 1800h:5, the event timer of TPDO1: 10 ms
            receive(bench, 0x600 + node, {0x2B, 0x00, 0x18, 0x05, 10, 0, 0, 0});
        }
        if (number == start_passes + 40) {
            receive(bench, 0x000, {0x01, static_cast<std::uint8_t>(node)});
        }
        bench.bus_is_busy = number > 500 && number < 1500;
        bench.chip.adc.codes[0] = number < 1200 ? 0 : 24 * 4095 / 66;  // the supply of the AX130751: 0 V, then 24 V
        if (bench.bus_is_busy && number % 10 == 0) {
            receive(bench, 0x600 + node, {0x40, 0x00, 0x10, 0x00, 0, 0, 0, 0});
        }
    };
    EXPECT_TRUE(bench.run(1700));
    const auto sent = bench.take_sent();
    const auto is_answer = [node](const Frame& frame) { return frame.id == 0x580 + node; };
    EXPECT_GE(static_cast<std::size_t>(std::count_if(sent.begin(), sent.end(), is_answer)),
              TransmitQueue::capacity / 2);
    EXPECT_EQ(FlashedBench::take_record(), stm32f405::SelfTest::none);
}

/// Runs the image with a fault that `act` causes. The image must record the failed self-test, leave the bus, and not
/// refresh the watchdog any more.
inline void expect_failure(const FlashedImage& image, stm32f405::SelfTest test,
                           const std::function<void(FlashedBench&)>& act) {
    FlashedBench bench{image};
    act(bench);
    EXPECT_TRUE(bench.run(start_passes + 500));
    EXPECT_EQ(FlashedBench::take_record(), test);
    EXPECT_NE(bench.chip.can.receive(data_frame(0x603, 8)), BxcanModel::Taken::kept);
    EXPECT_FALSE(bench.chip.watchdog.has_bitten());
    bench.chip.watchdog.pass(980);  // at least 20 ms have passed without a refresh; the period is 1 s
    EXPECT_TRUE(bench.chip.watchdog.has_bitten());
}

/// Returns the first byte of the device's settings.
template <typename Device>
void* first_setting(const Device& device) {
    const std::uint8_t* first = nullptr;
    for_each_piece(device.settings(),
                   [&first](const std::uint8_t* begin, std::size_t) { first = first == nullptr ? begin : first; });
    return const_cast<std::uint8_t*>(first);
}

/// Each self-test that fails in the main loop.
template <typename Device>
void runs_with_failed_self_tests(const FlashedImage& image) {
    using stm32f405::SelfTest;
    auto& device = *static_cast<Device*>(image.device);
    const auto at_start = [](FlashedBench& bench, auto act) {
        bench.on_pass = [&bench, act] {
            if (bench.passes() == start_passes) {
                act();
            }
        };
    };
    expect_failure(image, SelfTest::core, [](FlashedBench&) { core_model().registers_hold = false; });
    expect_failure(image, SelfTest::core,
                   [&](FlashedBench& bench) { at_start(bench, [] { core_model().registers_hold = false; }); });
    expect_failure(image, SelfTest::state,
                   [&](FlashedBench& bench) { at_start(bench, [&] { bench.damage(image.queue); }); });
    expect_failure(image, SelfTest::state, [&](FlashedBench& bench) {
        at_start(bench, [&] {
            const std::uint32_t rate = device.bit_rate();
            auto* const begin = static_cast<std::uint8_t*>(image.device);
            const auto* const value = reinterpret_cast<const std::uint8_t*>(&rate);
            for (auto* at = begin; device.bit_rate() == rate && at + sizeof rate <= begin + sizeof device; at += 4) {
                if (std::equal(value, value + sizeof rate, at)) {
                    bench.damage(at);
                }
            }
            EXPECT_NE(device.bit_rate(), rate);
        });
    });
    expect_failure(image, SelfTest::state,
                   [&](FlashedBench& bench) { at_start(bench, [&] { bench.damage(first_setting(device)); }); });
    expect_failure(image, SelfTest::flow,
                   [&](FlashedBench& bench) { at_start(bench, [&] { bench.damage(flow_signature(image)); }); });
}

/// The outputs and settings that change while the loop is in a pass.
template <typename Device>
void runs_with_failures_in_a_pass(const FlashedImage& image) {
    using stm32f405::SelfTest;
    auto& device = *static_cast<Device*>(image.device);
    // `when`: whether to act before this read, in a pass that has (samples) or has not read the inputs
    const auto in_pass = [](FlashedBench& bench, auto when, auto act) {
        auto done = std::make_shared<bool>(false);
        bench.on_read = [&bench, when, act, done](std::uintptr_t address) {
            if (bench.passes() > start_passes && !*done && when(bench, address)) {
                *done = true;
                act();
            }
        };
    };
    const auto at_inputs = [](FlashedBench&, std::uintptr_t address) { return is_input(address); };
    const auto outputs = [&device] { return const_cast<void*>(static_cast<const void*>(&device.outputs())); };
    // before the device computes
    expect_failure(image, SelfTest::outputs,
                   [&](FlashedBench& bench) { in_pass(bench, at_inputs, [&, outputs] { bench.damage(outputs()); }); });
    // after the device has computed: the loop reads CAN_MSR twice in a pass
    expect_failure(image, SelfTest::outputs, [&](FlashedBench& bench) {
        in_pass(
            bench, [](FlashedBench& present, std::uintptr_t) { return present.status_reads() == 2; },
            [&, outputs] { bench.damage(outputs()); });
    });
    expect_failure(image, SelfTest::state, [&](FlashedBench& bench) {
        in_pass(bench, at_inputs, [&] { bench.damage(first_setting(device)); });
    });
}

}  // namespace canproof::test
