// SPDX-License-Identifier: Apache-2.0
// Properties of the whole AX188001: its frames agree with a naive model of limits and delays, and do not depend on how
// often advance() is called (manual, 1.1, 3.3.6, 3.4.13 to 3.4.16).
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <optional>

#include "generated/ax188001/requirements.hpp"
#include "tests/devices/ax188001/tcs_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

int any(int low, int high) {
    return *rc::gen::inRange(low, high + 1);
}

/// A limit of the naive model. passed() says which readings begin the fault, ended() which end it.
struct ModelLimit {
    int set_c;
    int clear_c;
    bool high;
    const char* description;

    bool passed(double celsius) const { return high ? celsius > set_c : celsius < set_c; }
    bool ended(double celsius) const { return high ? celsius <= clear_c : celsius >= clear_c; }
};

/// Returns the times in ms at which the fault of one limit is reported (true) or cleared (false). The readings are 165
/// ms apart, the first one at 0 ms.
std::vector<std::pair<int, bool>> history(const ModelLimit& limit, const std::vector<double>& readings, int delay_ms) {
    std::vector<std::pair<int, bool>> events;
    std::optional<int> since;
    bool told = false;
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const int now = static_cast<int>(i) * 165;
        if (since && *since + delay_ms < now) {
            events.emplace_back(*since + delay_ms, true);
            told = true;
            since.reset();
        }
        if (told) {
            if (limit.ended(readings[i])) {
                events.emplace_back(now, false);
                told = false;
            }
        } else if (!limit.passed(readings[i])) {
            since.reset();
        } else {
            since = since ? since : now;
            if (*since + delay_ms == now) {
                events.emplace_back(now, true);
                told = true;
                since.reset();
            }
        }
    }
    return events;
}

/// Returns the emergency messages of all limits in one list, as `ms:frame`.
Frames messages(const std::vector<ModelLimit>& limits, const std::vector<double>& readings, int delay_ms) {
    std::multimap<int, std::pair<std::size_t, bool>> events;
    for (std::size_t i = 0; i < limits.size(); ++i) {
        for (const auto& [at, set] : history(limits[i], readings, delay_ms)) {
            events.emplace(at, std::pair{i, set});
        }
    }
    Frames all;
    std::vector<bool> active(limits.size(), false);
    for (auto now = events.begin(); now != events.end(); now = events.upper_bound(now->first)) {
        for (std::size_t i = 0; i < limits.size(); ++i) {
            for (auto one = now; one != events.upper_bound(now->first); ++one) {
                if (one->second.first != i) {
                    continue;
                }
                active[i] = one->second.second;
                const bool left = std::find(active.begin(), active.end(), true) != active.end();
                all.push_back(fmt::format("{}:0FF#", now->first) +
                              (active[i] ? fmt::format("11F00101{}000000", limits[i].description)
                                         : fmt::format("00000{}0000000000", left ? 1 : 0)));
            }
        }
    }
    return all;
}

}  // namespace

RC_GTEST_PROP(Ax188001Law, LimitFaultsAreReportedAsTheNaiveModelPredicts, ()) {
    verifies<req::TCS_LIM_002, req::TCS_LIM_003, req::TCS_LIM_012>("property");
    const int low = any(-150, 0);
    const int high = low + any(10, 100);
    const int shutdown = high + any(10, 60);
    const int delay_ms = *rc::gen::element(0, any(0, 1000), any(0, 10) * 165, 60000);
    // The readings are multiples of half a degree. So each equals a threshold or is at least half a degree away from
    // it, and neither the steps of the converter nor rounding decides whether a limit is exceeded.
    const auto degrees = *rc::gen::container<std::vector<int>>(rc::gen::inRange(low - 12, shutdown + 12));

    TcsBench bench;
    bench.power_on();
    // Starts within all limits, so that no fault is reported or waits for its delay. Then sets the thresholds in an
    // order that keeps neighbouring thresholds at least 10 degC apart at every write.
    bench.heat(1, low + 5.5);
    bench.settle();
    const auto threshold = [&](int index, int celsius) {
        RC_ASSERT(bench.write(index, 1, 2, static_cast<std::uint32_t>(celsius * 10) & 0xFFFFU) == 0U);
    };
    threshold(0x4000, -273);
    threshold(0x4020, 1735);
    threshold(0x4010, high);
    threshold(0x4000, low);
    threshold(0x4020, shutdown);
    RC_ASSERT(bench.write(0x4030, 1, 2, static_cast<std::uint32_t>(delay_ms)) == 0U);

    std::vector<double> readings{low + 5.5};
    Frames seen;
    for (const int one : degrees) {
        bench.heat(1, one + 0.5);
        readings.push_back(one + 0.5);
        for (const auto& frame : bench.pass(165)) {
            const auto colon = frame.find(':');
            const int at = std::stoi(frame) + static_cast<int>(readings.size() - 2) * 165;
            seen.push_back(std::to_string(at) + frame.substr(colon));
        }
    }
    const std::vector<ModelLimit> limits{
        {high, high - 1, true, "10"}, {low, low + 1, false, "20"}, {shutdown, shutdown - 1, true, "40"}};
    RC_ASSERT(seen == messages(limits, readings, delay_ms));
}

RC_GTEST_PROP(Ax188001Law, FramesDoNotDependOnHowOftenAdvanceIsCalled, ()) {
    verifies<req::TCS_IN_015>("property");
    struct Step {
        int wait_ms;
        int what;
        int value;
    };
    std::vector<Step> steps;
    for (int i = any(1, 12); i > 0; --i) {
        steps.push_back({any(0, 900), any(0, 5), any(-100, 320)});
    }
    const auto run = [&](bool often) {
        TcsBench bench;
        Frames all = bench.power_on();
        bench.write(0x4030, 1, 2, 400);
        bench.write(0x5051, 1, 2, 300);
        const auto add = [&](const Frames& frames) {
            for (const auto& frame : frames) {
                all.push_back(std::to_string(bench.now.us) + " " + frame);
            }
        };
        const auto wait = [&](int ms) {
            const std::uint64_t begin = bench.now.us;
            for (int left = ms; left > 0;) {
                const int part = often ? std::min(left, 7) : left;
                const std::uint64_t base = (bench.now.us - begin) / 1000;
                for (const auto& frame : bench.pass(static_cast<std::uint64_t>(part))) {
                    all.push_back(std::to_string(base + static_cast<std::uint64_t>(std::stoi(frame))) +
                                  frame.substr(frame.find(':')));
                }
                if (often) {
                    bench.device->advance(bench.now);
                    add(bench.sent());
                }
                left -= part;
            }
        };
        for (const Step& step : steps) {
            wait(step.wait_ms);
            if (step.what == 0) {
                add(bench.heat(1, step.value));
            } else if (step.what == 1) {
                add(bench.cut(1, step.value > 100));
            } else if (step.what == 2) {
                bench.inputs.cpu_temperature = static_cast<float>(step.value);
                add(bench.set_inputs());
            } else if (step.what == 3) {
                add(bench.send(step.value > 0 ? "000#017F" : "000#807F"));
            } else if (step.what == 4) {
                add(bench.send("67F#4030710100000000"));
            } else {
                add(bench.send(step.value > 0 ? "67F#2F12610101000000" : "67F#2F12610100000000"));
            }
        }
        wait(3000);
        return all;
    };
    RC_ASSERT(run(false) == run(true));
}

RC_GTEST_PROP(Ax188001Law, MeasuredProcessValueIsNeverAReservedValue, ()) {
    verifies<req::TCS_VAL_007>("property");
    TcsBench bench;
    bench.power_on();
    bench.write_real(0x6126, 1, static_cast<float>(any(-1000, 1000)));
    bench.write_real(0x6127, 1, static_cast<float>(any(-10000, 10000)));
    bench.heat(1, any(-200, 320));
    bench.settle();
    const int value = bench.process_value(1);
    RC_ASSERT(value != -1 && value != -512);
    bench.write(0x6112, 1, 1, 0);
    RC_ASSERT(bench.process_value(1) == -1);
}

}  // namespace canproof::test
