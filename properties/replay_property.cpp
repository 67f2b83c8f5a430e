// Replay of any stimuli and frames: time never goes back.
#include <gtest/gtest.h>
// rapidcheck's GoogleTest support needs gtest first
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "host/cli/built_in.hpp"
#include "host/devices/simulated_device.hpp"
#include "host/replay/replay.hpp"

namespace canproof::host {

namespace {

constexpr int node = 5;

/// Ascending times of up to two seconds.
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

/// Any input of the device, at any value that it takes.
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

/// Times in the first column, between brackets or not.
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

}  // namespace

RC_GTEST_PROP(ReplayLaw, TimesNeverDecrease, ()) {
    static const std::vector<std::string> names{"cbx-ao412", "ax188001", "ax060805", "ax130751"};
    const std::string name = *rc::gen::elementOf(names);
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
