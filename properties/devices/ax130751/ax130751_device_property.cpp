// SPDX-License-Identifier: Apache-2.0
// Properties of the whole AX130751 for any configuration and any inputs.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <cmath>

#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

struct Write {
    std::uint16_t index;
    int sub;
    int value;
    int bytes;
};

Write some(std::uint16_t index, int subs, int low, int high, int bytes) {
    return {index, *rc::gen::inRange(1, subs + 1), *rc::gen::inRange(low, high + 1), bytes};
}

/// Returns one write to a parameter. The write may be refused, but then all devices that the property compares refuse
/// it.
Write some_write() {
    const auto table = static_cast<std::uint16_t>(0x10 * *rc::gen::inRange(1, 10));
    const auto block = static_cast<std::uint16_t>(0x100 * *rc::gen::inRange(0, 3));
    const auto plain = [](std::uint16_t index, int low, int high) {
        return Write{index, 0, *rc::gen::inRange(low, high + 1), 1};
    };
    switch (*rc::gen::inRange(0, 30)) {
        case 0:
            return {0x6310, *rc::gen::inRange(1, 3), *rc::gen::element(0, 10, 20, 40, 500, 1020), 2};
        case 1:
        case 2:
            return some(0x7300, 2, -2000, 9000, 2);
        case 3:
            return some(0x6220, 3, 0, 1, 1);
        case 4:
        case 5:
        case 6:
            return some(0x2500, 6, -100, 1200, 2);
        case 7:
            return some(0x2522, 6, 0, 1000, 2);
        case 8:
            return some(*rc::gen::element<std::uint16_t>(0x2330, 0x2331), 2, 0, 300, 2);
        case 9:
        case 10:
            return some(*rc::gen::element<std::uint16_t>(0x2340, 0x2350, 0x2360), 2, 0, 9, 1);
        case 11:
            return some(*rc::gen::element<std::uint16_t>(0x2341, 0x2351, 0x2361), 2, 0, 10, 1);
        case 12:
            return some(0x2352, 2, 0, 5, 1);
        case 13:
            return some(*rc::gen::element<std::uint16_t>(0x2342, 0x2362, 0x6340), 2, 0, 1, 1);
        case 14:
            return some(*rc::gen::element<std::uint16_t>(0x2300, 0x7321, 0x7323), 2, -10000, 10000, 2);
        case 15:
            return some(0x2241, 2, 0, 3, 1);
        case 16:
            return some(0x2223, 2, 0, 90, 2);
        case 17:
            return {0x2242, 1, *rc::gen::inRange(0, 6), 1};
        case 18:
            return some(*rc::gen::element<std::uint16_t>(0x2260, 0x2270, 0x2280, 0x2290), 1, 0, 9, 1);
        case 19:
            return some(*rc::gen::element<std::uint16_t>(0x2261, 0x2271, 0x2281, 0x2291), 1, 0, 9, 1);
        case 20:
            return some(*rc::gen::element<std::uint16_t>(0x22A1, 0x22A2), 1, 0, 90, 4);
        case 21:
            return some(*rc::gen::element<std::uint16_t>(0x22A0, 0x2293), 1, 0, 1, 1);
        case 22:
            return plain(static_cast<std::uint16_t>(0x3000 + table), 0, 9);
        case 23:
            return plain(static_cast<std::uint16_t>(0x3001 + table), 1, 9);
        case 24:
            return some(static_cast<std::uint16_t>(0x3005 + table), 11, 0, 2, 1);
        case 25:
            return some(static_cast<std::uint16_t>(0x3006 + table), 11, 0, 100, 4);
        case 26:
            return some(static_cast<std::uint16_t>(0x3007 + table), 11, -300, 300, 2);
        case 27:
            return some(*rc::gen::element<std::uint16_t>(0x3300, 0x4000), 3, 0, 1, 1);
        case 28:
            return some(static_cast<std::uint16_t>(0x4100 + block), 4, 0, 9, 1);
        default:
            return some(static_cast<std::uint16_t>(0x4101 + block), 4, 1, 9, 1);
    }
}

/// Returns the outputs of the device and the process values of all blocks. Leaves out math block 4, which no write
/// configures.
std::vector<double> observe(Ax130751Bench& bench) {
    std::vector<double> seen;
    generated::ax130751::for_each_output(bench.device->outputs(), [&seen](const char*, const auto& value) {
        seen.push_back(static_cast<double>(value));
    });
    for (int n = 1; n <= 10; ++n) {
        seen.push_back(
            static_cast<double>(bench.read(static_cast<std::uint16_t>(n == 10 ? 0x3108 : 0x3008 + 0x10 * n), 0)));
    }
    for (const std::uint16_t index : std::vector<std::uint16_t>{0x3310, 0x3320, 0x4030}) {
        for (int n = 1; n <= 3; ++n) {
            seen.push_back(static_cast<double>(bench.read(index, n)));
        }
    }
    for (const std::uint16_t index : std::vector<std::uint16_t>{0x7330, 0x2370}) {
        for (int n = 1; n <= 2; ++n) {
            seen.push_back(static_cast<double>(bench.read(index, n)));
        }
    }
    return seen;
}

}  // namespace

RC_GTEST_PROP(Ax130751Law, OutputsDoNotDependOnHowOftenAdvanceIsCalled, ()) {
    verifies<req::AOR_OUT_027>("property");
    Ax130751Bench on_time;   // the test calls advance() at each deadline of this device
    Ax130751Bench late;      // the test calls advance() only at events
    Ax130751Bench restless;  // the test calls advance() at events and up to three times between them
    for (auto* bench : {&on_time, &late, &restless}) {
        bench->power_on();
        bench->start();  // outputs work only in operational
    }
    const int steps = *rc::gen::inRange(10, 120);
    for (int step = 0; step < steps; ++step) {
        const auto wait = *rc::gen::weightedOneOf<std::uint64_t>(
            {{3, rc::gen::just<std::uint64_t>(0)}, {3, rc::gen::inRange<std::uint64_t>(0, 400'000)}});
        on_time.pass(0);
        const Instant then = on_time.now + microseconds(wait);
        while (on_time.device->next_deadline() <= then) {
            on_time.now = on_time.device->next_deadline();
            on_time.device->advance(on_time.now);
        }
        const int calls = *rc::gen::inRange(0, 4);
        for (int call = 1; call <= calls; ++call) {
            restless.device->advance(restless.now + microseconds(wait * static_cast<std::uint64_t>(call) / 4U));
        }
        for (auto* bench : {&on_time, &late, &restless}) {
            bench->now = then;
            bench->device->advance(then);
            bench->sent();
        }
        const auto expected = observe(on_time);
        RC_ASSERT(observe(late) == expected);
        RC_ASSERT(observe(restless) == expected);
        const Write write = some_write();
        for (auto* bench : {&on_time, &late, &restless}) {
            bench->write(write.index, write.sub, write.value, write.bytes);
        }
    }
}

RC_GTEST_PROP(Ax130751Law, OutputsStayInTheWidestRangeOfAnyOutputTypeAfterAnyWrite, ()) {
    verifies<req::AOR_OUT_016, req::AOR_OUT_034>("property");
    Ax130751Bench bench;
    bench.power_on();
    bench.start();
    const int steps = *rc::gen::inRange(10, 150);
    for (int step = 0; step < steps; ++step) {
        const Write write = some_write();
        bench.write(write.index, write.sub, write.value, write.bytes);
        bench.pass(*rc::gen::inRange<std::uint64_t>(0, 50));
        const auto& outputs = bench.device->outputs();
        for (std::size_t n = 0; n < 2; ++n) {
            RC_ASSERT(outputs.out_voltage[n] >= -10.0F && outputs.out_voltage[n] <= 12.0F);
            RC_ASSERT(outputs.out_current[n] >= 0.0F && outputs.out_current[n] <= 24.0F);
            RC_ASSERT(outputs.out_duty[n] >= 0.0F && outputs.out_duty[n] <= 100.0F);
            const float hertz = outputs.out_frequency[n];
            RC_ASSERT(hertz <= 30000.0F && (hertz >= 50.0F || hertz <= 0.0F));
        }
        RC_ASSERT(outputs.relay_nc != outputs.relay_no);
    }
}

}  // namespace canproof::test
