// SPDX-License-Identifier: Apache-2.0
#include "host/report/output_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "firmware/base/time.hpp"
#include "host/base/input_error.hpp"
#include "host/base/utf8.hpp"
#include "host/sim/replay/replay.hpp"

namespace canproof::host {

namespace {

double seconds(Instant time) {
    return static_cast<double>(time.us) / 1.0e6;
}

Curve curve_of(const std::string& signal, const std::vector<Stimulus>& changes, double end) {
    Curve curve{shown_text(signal), {}};
    for (const Stimulus& change : changes) {
        if (change.signal != signal) {
            continue;
        }
        if (!curve.points.empty()) {
            curve.points.emplace_back(seconds(change.time), curve.points.back().second);
        }
        curve.points.emplace_back(seconds(change.time), change.value);
    }
    curve.points.emplace_back(end, curve.points.back().second);
    return curve;
}

std::vector<std::string> signals_that_change(const std::vector<Stimulus>& lines) {
    std::map<std::string, int> counts;
    std::vector<std::string> changing;
    for (const Stimulus& line : lines) {
        if (++counts[line.signal] == 2) {
            changing.push_back(line.signal);
        }
    }
    return changing;
}

}  // namespace

LinePlot output_plot(std::istream& csv, const std::string& name, const std::vector<std::string>& signals) {
    const std::vector<Stimulus> lines = read_stimuli(csv, name);
    const std::vector<std::string> chosen = signals.empty() ? signals_that_change(lines) : signals;
    for (const std::string& signal : chosen) {
        if (std::none_of(lines.begin(), lines.end(), [&](const Stimulus& one) { return one.signal == signal; })) {
            throw InputError{
                fmt::format("{} has no signal {}; the second column of the file names the signals", name, signal)};
        }
    }
    if (chosen.empty() || lines.back().time.us == 0) {
        throw InputError{
            fmt::format("{}: no signal has a second line, or no line is later than 0 s, so there is nothing to draw; "
                        "use the --outputs of a run in which an output changes",
                        name)};
    }
    LinePlot plot;
    plot.title = shown_text(name);
    plot.x_label = "time, s";
    plot.y_label = "value";
    for (const std::string& signal : chosen) {
        plot.curves.push_back(curve_of(signal, lines, seconds(lines.back().time)));
    }
    return plot;
}

}  // namespace canproof::host
