// SPDX-License-Identifier: Apache-2.0
// Replays any stimuli and frames. Times in the output never decrease, and the replay of a recorded run contains the
// frames of the run in their order.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "devices/catalogue.hpp"
#include "host/base/time_text.hpp"
#include "host/selection/built_in.hpp"
#include "host/selection/chosen_devices.hpp"
#include "host/sim/bus/arbitrated_bus.hpp"
#include "host/sim/devices/simulated_device.hpp"
#include "host/sim/replay/replay.hpp"
#include "host/sim/run/run_session.hpp"
#include "tests/support/every_device.hpp"

namespace canproof::host {

namespace {

constexpr int node = 5;

/// Returns at most `most` times between 0 and 2 s, in ascending order.
std::vector<Instant> any_times(std::size_t most) {
    auto times = *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange<std::uint32_t>(0, 2000000));
    times.resize(std::min(times.size(), most));
    std::sort(times.begin(), times.end());
    std::vector<Instant> all;
    for (const std::uint32_t us : times) {
        all.push_back(Instant{us});
    }
    return all;
}

/// Returns a stimulus of any input with any accepted value.
Stimulus any_stimulus(const Part& part, Instant time) {
    std::vector<const Signal*> inputs;
    for (const Signal& signal : part.signals) {
        if (signal.input) {
            inputs.push_back(&signal);
        }
    }
    const Signal& signal = **rc::gen::elementOf(inputs);
    const double low = signal.minimum.value_or(0.0);
    const double high = signal.maximum.value_or(1.0);
    const bool is_real = signal.type == "REAL32";
    const double part_of_range = static_cast<double>(*rc::gen::inRange(0, 101)) / 100.0;
    const double value = low + part_of_range * (high - low);
    return {"law", time, *rc::gen::elementOf(signal.names()), is_real ? value : std::floor(value)};
}

LoggedFrame any_frame(Instant time) {
    static const std::vector<std::string> requests{"000#0105",
                                                   "000#0205",
                                                   "000#8005",
                                                   "000#8205",
                                                   "080#",
                                                   "605#2B17100064000000",
                                                   "705#R",
                                                   "205#FF7F",
                                                   "185#",
                                                   "605#2F00620101000000",
                                                   "605#2B1164010FFF0000"};
    return {time, "can0", parse_frame(*rc::gen::elementOf(requests), "law")};
}

/// Returns whether the times in the first column of `text`, a log or a table, never decrease. The times may be in
/// brackets.
bool never_decreases(const std::string& text, bool heading) {
    std::istringstream lines{text};
    Instant last{};
    bool holds = true;
    for (std::string line; std::getline(lines, line); heading = false) {
        if (!heading) {
            const std::size_t begin = line.front() == '(' ? 1 : 0;
            const Instant time = parse_seconds(line.substr(begin, line.find_first_of(",)") - begin), "law");
            holds = holds && last <= time;
            last = time;
        }
    }
    return holds;
}

/// Returns the log of a run, which marks each frame as received or sent. In the run, nodes 5 and 6 get random requests
/// at random times, which may fill the bus.
std::string any_run() {
    static const std::vector<std::string> requests{"000#0100",
                                                   "000#8000",
                                                   "000#8205",
                                                   "080#",
                                                   "605#2B17100003000000",
                                                   "705#R",
                                                   "606#2B17100005000000",
                                                   "205#FF7F",
                                                   "305#FF7FFF7F",
                                                   "605#4008100000000000",
                                                   "605#6000000000000000",
                                                   "606#4000100000000000",
                                                   "606#4018100400000000",
                                                   "605#2F00180205000000"};
    std::vector<std::unique_ptr<DeviceNode>> nodes;
    nodes.push_back(std::make_unique<DeviceNode>("five", choose_device("cbx-ao412@5").device));
    nodes.push_back(std::make_unique<DeviceNode>("six", choose_device("ax188001@6").device));
    std::ostringstream log;
    SessionOutputs outputs;
    outputs.log = &log;
    outputs.log_format = LogFormat::marked;
    RunSession session{
        std::make_unique<ArbitratedBus>("inproc", 125000, BusFaultRates{}), std::move(nodes), {}, outputs};
    session.power_on();
    Instant now{10000};
    const auto gaps = *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange<std::uint32_t>(0, 5000));
    for (const std::uint32_t gap : gaps) {
        now = now + microseconds(gap);
        session.advance_to(now);
        session.put(parse_frame(*rc::gen::elementOf(requests), "law"));
    }
    session.advance_to(now + milliseconds(100));
    return log.str();
}

/// Returns the log lines of the frames that node `of_node` sent, without the mark that says who sent the frame.
std::vector<std::string> lines_of(const std::string& log, int of_node) {
    std::istringstream in{log};
    std::vector<std::string> lines;
    for (const LoggedFrame& one : read_candump_log(in, "law")) {
        if (one.mark == LogMark::transmitted && (one.frame.id & 0x7FU) == static_cast<unsigned>(of_node)) {
            lines.push_back(format_candump_line(one));
        }
    }
    return lines;
}

/// Returns whether `all` contains all lines of `some` in the same order.
bool holds_in_order(const std::vector<std::string>& all, const std::vector<std::string>& some) {
    auto at = all.begin();
    for (const std::string& line : some) {
        at = std::find(at, all.end(), line);
        if (at == all.end()) {
            return false;
        }
        ++at;
    }
    return true;
}

}  // namespace

// The replay may contain more frames than the run: it has no bus, so it also contains frames that a reset dropped while
// they waited for the bus in the run.
RC_GTEST_PROP(ReplayLaw, ReplayContainsTheFramesOfTheRecordedRunInTheirOrder, ()) {
    const std::string log = any_run();
    for (const auto& [name, of_node] : {std::pair{"cbx-ao412", 5}, std::pair{"ax188001", 6}}) {
        const auto device = make_device(name);
        device->set_node_id(of_node);
        std::istringstream in{log};
        ReplayInput input;
        input.frames = read_candump_log(in, "law");
        std::ostringstream again;
        replay(*device, input, again, nullptr);
        std::istringstream lines{again.str()};
        std::vector<std::string> replayed;
        for (std::string line; std::getline(lines, line);) {
            replayed.push_back(line);
        }
        RC_ASSERT(holds_in_order(replayed, lines_of(log, of_node)));
    }
}

RC_GTEST_PROP(ReplayLaw, TimesInAReplayNeverDecrease, ()) {
    const std::string name = *rc::gen::elementOf(canproof::test::every_device());
    const auto device = make_device(name);
    device->set_node_id(node);
    ReplayInput input;
    for (const Instant time : any_times(20)) {
        input.stimuli.push_back(any_stimulus(device_named(name), time));
    }
    for (const Instant time : any_times(20)) {
        input.frames.push_back(any_frame(time));
    }
    check_stimuli(input.stimuli, {&device_named(name)});
    std::ostringstream frames;
    std::ostringstream outputs;
    replay(*device, input, frames, &outputs);
    RC_ASSERT(never_decreases(frames.str(), false));
    RC_ASSERT(never_decreases(outputs.str(), true));
}

}  // namespace canproof::host
