// SPDX-License-Identifier: Apache-2.0
#include "host/assess/inject/fault_effect.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

#include "host/base/input_error.hpp"

namespace canproof::host {

namespace {

constexpr std::uint32_t function_mask = 0x780;
constexpr std::uint32_t emcy_function = 0x080;
constexpr std::uint32_t error_control_function = 0x700;

using SentFrame = std::tuple<std::uint64_t, std::uint32_t, std::vector<std::uint8_t>>;

std::vector<std::uint8_t> data_of(const Frame& frame) {
    return {frame.data.begin(), frame.data.begin() + frame.length};
}

SentFrame sent(const LoggedFrame& logged) {
    return {logged.time.us, logged.frame.id, data_of(logged.frame)};
}

std::uint32_t function_of(const Frame& frame) {
    return frame.id & function_mask;
}

/// Returns whether the frame is an EMCY message. EMCY has the identifier 80h + node-ID; SYNC has 80h.
bool is_emcy(const Frame& frame) {
    return function_of(frame) == emcy_function && frame.id != emcy_function;
}
bool is_error_control(const Frame& frame) {
    return function_of(frame) == error_control_function;
}
/// Returns whether the frame is one of TPDOs 1 to 4. In the predefined connection set, they have the identifiers 180h,
/// 280h, 380h and 480h + node-ID.
bool is_pdo(const Frame& frame) {
    return function_of(frame) >= 0x180 && function_of(frame) < 0x580 && (frame.id & 0x80U) != 0;
}

template <typename Chosen>
std::vector<SentFrame> chosen_frames(const DeviceRun& run, Chosen chosen) {
    std::vector<SentFrame> all;
    for (const LoggedFrame& one : run.frames) {
        if (chosen(one.frame)) {
            all.push_back(sent(one));
        }
    }
    return all;
}

template <typename Chosen>
bool differ(const DeviceRun& a, const DeviceRun& b, Chosen chosen) {
    return chosen_frames(a, chosen) != chosen_frames(b, chosen);
}

/// Returns whether `faulty` sends an EMCY message more often than `faultless`. Messages with equal data count as the
/// same message.
bool reports_an_error(const DeviceRun& faultless, const DeviceRun& faulty) {
    std::multiset<std::vector<std::uint8_t>> expected;
    for (const LoggedFrame& one : faultless.frames) {
        if (is_emcy(one.frame)) {
            expected.insert(data_of(one.frame));
        }
    }
    for (const LoggedFrame& one : faulty.frames) {
        if (is_emcy(one.frame)) {
            const auto known = expected.find(data_of(one.frame));
            if (known == expected.end()) {
                return true;
            }
            expected.erase(known);
        }
    }
    return false;
}

using Values = std::map<std::uint64_t, std::vector<std::uint8_t>>;  ///< the data of PDOs with one identifier, by the
                                                                    ///< time in µs at which each was sent

/// Returns whether `value` was the last value sent at or before `time`, or the first value sent after `time`.
bool was_sent_around(const Values& values, std::uint64_t time, const std::vector<std::uint8_t>& value) {
    const auto after = values.upper_bound(time);
    return (after != values.end() && after->second == value) ||
           (after != values.begin() && std::prev(after)->second == value);
}

/// Returns whether `faulty` sends a PDO with data that `faultless` did not send with this identifier around this time.
bool sends_a_wrong_value(const DeviceRun& faultless, const DeviceRun& faulty) {
    std::map<std::uint32_t, Values> expected;
    for (const LoggedFrame& one : faultless.frames) {
        expected[one.frame.id][one.time.us] = data_of(one.frame);
    }
    return std::any_of(faulty.frames.begin(), faulty.frames.end(), [&](const LoggedFrame& one) {
        return is_pdo(one.frame) && !was_sent_around(expected[one.frame.id], one.time.us, data_of(one.frame));
    });
}

using Signals = std::map<std::string, std::string>;

/// Returns the value of each signal after power-on.
Signals first_values(const DeviceRun& run) {
    Signals first;
    for (const OutputChange& change : run.outputs) {
        first.emplace(change.signal, change.value);
    }
    return first;
}

/// Applies the output changes that happen at or before `time` to `signals`, beginning with change number `next`. Sets
/// `next` to the number of the first change that is left.
void apply_changes(const std::vector<OutputChange>& changes, double time, std::size_t& next, Signals& signals) {
    for (; next < changes.size() && std::stod(changes[next].time) <= time; ++next) {
        signals[changes[next].signal] = changes[next].value;
    }
}

/// Returns whether, at all times, each output has either its value in the run without the fault or its value after
/// power-on.
bool is_right_or_off(const DeviceRun& faultless, const DeviceRun& faulty) {
    const Signals off = first_values(faultless);
    Signals expected = off;
    Signals found = off;
    std::set<double> times;
    for (const DeviceRun* run : {&faultless, &faulty}) {
        for (const OutputChange& change : run->outputs) {
            times.insert(std::stod(change.time));
        }
    }
    std::size_t next_expected = 0;
    std::size_t next_found = 0;
    return std::all_of(times.begin(), times.end(), [&](double time) {
        apply_changes(faultless.outputs, time, next_expected, expected);
        apply_changes(faulty.outputs, time, next_found, found);
        return std::all_of(found.begin(), found.end(), [&](const auto& signal) {
            const auto usual = expected.find(signal.first);
            const auto at_start = off.find(signal.first);
            return (usual != expected.end() && usual->second == signal.second) ||
                   (at_start != off.end() && at_start->second == signal.second);
        });
    });
}

}  // namespace

DeviceRun read_run(const std::string& frames, const std::string& outputs) {
    DeviceRun run;
    std::istringstream frame_lines{frames};
    run.frames = read_candump_log(frame_lines, "frames of the run");
    std::istringstream output_lines{outputs};
    std::string line;
    std::getline(output_lines, line);  // skips the heading
    while (std::getline(output_lines, line)) {
        const auto first = line.find(',');
        const auto last = line.rfind(',');
        if (first == std::string::npos || first == last) {
            throw InputError{"a line of outputs does not have the form TIME,SIGNAL,VALUE: " + line};
        }
        run.outputs.push_back({line.substr(0, first), line.substr(first + 1, last - first - 1), line.substr(last + 1)});
    }
    return run;
}

FaultEffect effect_of(const DeviceRun& faultless, const DeviceRun& faulty) {
    if (reports_an_error(faultless, faulty)) {
        return FaultEffect::emergency;
    }
    if (differ(faultless, faulty, is_error_control)) {
        return FaultEffect::network;
    }
    if (faultless.outputs != faulty.outputs) {
        return is_right_or_off(faultless, faulty) ? FaultEffect::safe_state : FaultEffect::wrong_output;
    }
    if (sends_a_wrong_value(faultless, faulty)) {
        return FaultEffect::wrong_pdo;
    }
    if (differ(faultless, faulty, is_pdo)) {
        return FaultEffect::missing_pdo;
    }
    return differ(faultless, faulty, [](const Frame&) { return true; }) ? FaultEffect::wrong_answer
                                                                        : FaultEffect::masked;
}

const char* name_of(FaultEffect effect) {
    static constexpr std::array<const char*, fault_effects> names{
        "processor fault", "watchdog",     "EMCY",           "boot-up or heartbeat",
        "safe state",      "wrong output", "wrong PDO data", "PDO missing or late",
        "wrong answer",    "masked"};
    return names[static_cast<std::size_t>(effect)];
}

bool is_detected(FaultEffect effect) {
    return effect <= FaultEffect::network;
}

bool is_silent(FaultEffect effect) {
    return effect == FaultEffect::wrong_output || effect == FaultEffect::wrong_pdo;
}

}  // namespace canproof::host
