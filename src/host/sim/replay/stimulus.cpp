// SPDX-License-Identifier: Apache-2.0
#include "host/sim/replay/stimulus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/base/input_error.hpp"
#include "host/base/number_text.hpp"
#include "host/base/reading.hpp"
#include "host/base/time_text.hpp"

namespace canproof::host {

namespace {

double parse_value(const std::string& text, const std::string& where) {
    const auto value = decimal_or_hexadecimal(text);
    if (!value) {
        throw InputError{fmt::format("{}: value `{}` is not a finite number; write seconds,signal,value", where, text)};
    }
    return *value;
}

}  // namespace

std::vector<Stimulus> read_stimuli(std::istream& in, const std::string& name) {
    std::vector<Stimulus> all;
    LineReader lines{in, name};
    while (lines.next()) {
        const std::string& line = lines.line();
        if (line.empty() || (lines.number() == 1 && line == "seconds,signal,value")) {
            continue;
        }
        const std::string where = lines.where();
        const auto first = line.find(',');
        // Without a first comma `first` is npos, and npos + 1 is 0: the search then finds no second comma either.
        const auto second = line.find(',', first + 1);
        if (second == std::string::npos) {
            throw InputError{
                fmt::format("{}: `{}` does not have three fields; write seconds,signal,value", where, line)};
        }
        Stimulus one;
        one.where = where;
        one.time = parse_seconds(line.substr(0, first), where);
        one.signal = line.substr(first + 1, second - first - 1);
        one.value = parse_value(line.substr(second + 1), where);
        if (!all.empty() && one.time < all.back().time) {
            throw InputError{fmt::format("{}: time goes backwards; sort the lines by time", where)};
        }
        all.push_back(one);
    }
    return all;
}

namespace {

std::vector<const Signal*> inputs_named(const std::string& name, const std::vector<const Part*>& devices) {
    std::vector<const Signal*> found;
    for (const Part* device : devices) {
        for (const auto& signal : device->signals) {
            const auto names = signal.names();
            if (signal.input && std::find(names.begin(), names.end(), name) != names.end()) {
                found.push_back(&signal);
            }
        }
    }
    return found;
}

void check_value(const Stimulus& stimulus, const Signal& signal) {
    const bool is_truth = signal.type == "BOOLEAN";
    const bool is_real = signal.type == "REAL32" || signal.type == "REAL64";
    // every number in the register has a minimum and a maximum
    const double low = is_truth ? 0.0 : signal.minimum.value();
    const double high = is_truth ? 1.0 : signal.maximum.value();
    const bool whole = is_real || std::floor(stimulus.value) == stimulus.value;
    if (!whole || stimulus.value < low || stimulus.value > high) {
        throw InputError{fmt::format("{}: {} takes {} from {} to {}, not {}", stimulus.where, stimulus.signal,
                                     is_real ? "values" : "whole numbers", low, high, stimulus.value)};
    }
}

}  // namespace

void check_stimuli(const std::vector<Stimulus>& stimuli, const std::vector<const Part*>& devices) {
    for (const auto& stimulus : stimuli) {
        const std::vector<const Signal*> signals = inputs_named(stimulus.signal, devices);
        if (signals.empty()) {
            throw InputError{fmt::format("{}: there is no input `{}`; `canproof signals` lists the inputs",
                                         stimulus.where, stimulus.signal)};
        }
        for (const Signal* signal : signals) {
            check_value(stimulus, *signal);
        }
    }
}

}  // namespace canproof::host
