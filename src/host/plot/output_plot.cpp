#include "host/plot/output_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "host/bus/candump.hpp"
#include "host/devices/devices.hpp"
#include "host/replay/replay.hpp"

namespace canproof::host {

namespace {

double seconds(Instant time) {
    return static_cast<double>(time.us) / 1.0e6;
}

Curve curve_of(const std::string& signal, const std::vector<Stimulus>& changes, double end) {
    Curve curve{signal, {}};
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
                fmt::format("{} has no signal {}; its first column after the time names them", name, signal)};
        }
    }
    if (chosen.empty() || lines.back().time.us == 0) {
        throw InputError{fmt::format("{}: no signal changes after 0; there is nothing to draw", name)};
    }
    LinePlot plot;
    plot.title = name;
    plot.x_label = "time, s";
    plot.y_label = "value";
    for (const std::string& signal : chosen) {
        plot.curves.push_back(curve_of(signal, lines, seconds(lines.back().time)));
    }
    return plot;
}

LinePlot analog_outputs_plot() {
    std::istringstream log{
        "(0.010000) can0 603#2B116401B33E0000\n"  // output 1 to 5.0 V
        "(0.020000) can0 603#2B1164024DC10000\n"  // output 2 to -5.0 V
        "(0.030000) can0 000#0103\n"
        "(0.040000) can0 303#0020B33EA041A041\n"
        "(0.050000) can0 303#0040B33E00E0A041\n"
        "(0.060000) can0 303#00604DC100C0A041\n"
        "(0.070000) can0 303#000000000000A041\n"
        "(0.080000) can0 303#0000000000000000\n"};
    const auto device = make_device("cbx-ao412");
    device->set_node_id(3);
    std::ostringstream frames;
    std::stringstream outputs;
    ReplayInput input;
    input.frames = read_candump_log(log, "example");
    input.until = Instant{90000};
    replay(*device, input, frames, &outputs);
    LinePlot plot = output_plot(outputs, "CBX-AO412", {"aout1", "aout2", "aout3", "aout4"});
    plot.title = "CAN-CBX-AO412: outputs set by SDO and by RPDO";
    plot.y_label = "voltage, V";
    return plot;
}

}  // namespace canproof::host
