// SPDX-License-Identifier: Apache-2.0
#include "devices/ax188001/simulation/thermocouple_figures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "devices/ax188001/firmware/ax188001.hpp"
#include "devices/ax188001/firmware/thermocouple_curves.hpp"
#include "devices/ax188001/simulation/exact_reference.hpp"
#include "devices/ax188001/simulation/simulation.hpp"
#include "generated/ax188001/constants.hpp"
#include "generated/ax188001/enumerations.hpp"
#include "host/sim/replay/replay.hpp"

namespace canproof::ax188001 {

using namespace host;

namespace {

using generated::ax188001::SensorType;

struct NamedType {
    SensorType type;
    const char* name;
};
constexpr NamedType types[]{{SensorType::j, "J"}, {SensorType::k, "K"}, {SensorType::n, "N"}, {SensorType::r, "R"},
                            {SensorType::s, "S"}, {SensorType::t, "T"}, {SensorType::e, "E"}, {SensorType::b, "B"}};

constexpr double sixteenths = 16.0;  // by default 7130h (TC Input Process Value) is 16 * °C + 4368
constexpr double offset = 4368.0;

/// An AX188001 alone on a bus with one thermocouple; the plots read the objects of the AX188001 over SDO.
class Bench {
  public:
    explicit Bench(SensorType type) : curve_{thermocouple_curve(type)} {
        device_.power_on(inputs_, now_);
        ask(fmt::format("67F#2B106101{:02X}000000", static_cast<int>(type)));
    }
    /// Returns 6100h:1 input field value after the hot junction has been at `celsius` for the settling time that the
    /// manual allows.
    double settled_field_value(double celsius) {
        const double mv =
            reference_mv(curve_, celsius) - reference_mv(curve_, static_cast<double>(inputs_.cold_junction));
        inputs_.tc_microvolts[0] = static_cast<float>(mv * 1000.0);
        device_.set_inputs(inputs_, now_);
        const Instant end = now_ + milliseconds(1500);
        while (device_.next_deadline() <= end) {
            now_ = device_.next_deadline();
            device_.advance(now_);
        }
        now_ = end;
        const auto bits = read_u32(ask("67F#4000610100000000").payload(), 4);
        return static_cast<double>(bit_cast<float>(bits));
    }

  private:
    /// Sends an SDO request and returns the answer; emergency messages before it are skipped.
    Frame ask(const std::string& request) {
        device_.receive(parse_frame(request, "figure"), now_);
        Frame last{};
        while (!queue_.empty()) {
            last = queue_.pop();
        }
        return last;
    }

    const ThermocoupleCurve& curve_;
    Memory memory_{1024};
    TransmitQueue queue_;
    ax188001::Device device_{memory_, queue_, {}};
    ax188001::Inputs inputs_{};
    Instant now_{};
};

double to_celsius(std::int16_t process_value) {
    return process_value == generated::ax188001::process_value_open ||
                   process_value == generated::ax188001::process_value_disabled
               ? std::numeric_limits<double>::quiet_NaN()
               : (static_cast<double>(process_value) - offset) / sixteenths;
}

std::string emergency_word(const Frame& frame) {
    using Code = generated::ax188001::EmergencyCode;
    using Description = generated::ax188001::ErrorDescription;
    const std::uint16_t code = read_u16(frame.payload(), 0);
    const auto description = static_cast<Description>(frame.data[4]);
    return code == 0                                                ? "cleared"
           : code == static_cast<std::uint16_t>(Code::open_circuit) ? "open circuit"
           : description == Description::positive_warning           ? "high warning"
           : description == Description::negative_warning           ? "low warning"
                                                                    : "shutdown";
}

/// Plots the error of `inversion`, which converts mV to °C, from `lowest(type)` to the end of each type's range.
LinePlot error_plot(const char* title, double (*inversion)(const ThermocoupleCurve&, double),
                    double (*lowest)(const ThermocoupleCurve&)) {
    LinePlot plot{title, "temperature / °C", "error / °C", {}, {}};
    for (const auto& [type, name] : types) {
        const ThermocoupleCurve& curve = thermocouple_curve(type);
        const double low = lowest(curve);
        Curve drawn{name, {}};
        constexpr int steps = 600;
        for (int i = 0; i <= steps; ++i) {
            const double celsius = low + (curve.highest_c() - low) * i / steps;
            const double mv = static_cast<double>(reference_mv_exactly(type, static_cast<long double>(celsius)));
            drawn.points.emplace_back(celsius, inversion(curve, mv) - celsius);
        }
        plot.curves.push_back(std::move(drawn));
    }
    return plot;
}

}  // namespace

LinePlot conversion_error_plot() {
    // Type B has almost no slope below 42 °C.
    return error_plot("AX188001: error of the linearisation alone (0.02 °C allowed)", exact_celsius,
                      [](const ThermocoupleCurve& curve) { return curve.lowest_c() > 0.0 ? 42.0 : curve.lowest_c(); });
}

LinePlot inverse_error_plot() {
    return error_plot(
        "AX188001: the published inverse functions alone, where the linearisation begins", approximate_celsius,
        [](const ThermocoupleCurve& curve) { return exact_celsius(curve, from_fixed(curve.inverse[0].begin)); });
}

LinePlot channel_error_plot() {
    LinePlot plot{"AX188001: field value less hot junction (1 °C promised)", "hot junction / °C", "error / °C", {}, {}};
    for (const auto& [type, name] : types) {
        const ThermocoupleCurve& curve = thermocouple_curve(type);
        // The plot of type B begins at the lowest temperature at which half a step of the converter (0.3 µV here) is
        // less than a degree.
        const double low = type == SensorType::b ? 50.0 : curve.lowest_c();
        Bench bench{type};
        Curve drawn{name, {}};
        constexpr int steps = 300;
        for (int i = 0; i <= steps; ++i) {
            const double celsius = low + (curve.highest_c() - low) * i / steps;
            drawn.points.emplace_back(celsius, bench.settled_field_value(celsius) - celsius);
        }
        plot.curves.push_back(std::move(drawn));
    }
    return plot;
}

LinePlot ramp_plot() {
    LinePlot plot{
        "AX188001: a ramp through all limits, the wire broken from 46 to 55 s", "time / s", "temperature / °C", {}, {}};
    Curve hot{"hot junction", {}};
    Curve shown{"7130h on TPDO1", {}};
    ReplayInput input;
    const auto set = [&](int second, const char* signal, double value) {
        input.stimuli.push_back({"ramp", Instant{static_cast<std::uint64_t>(second) * 1000000U}, signal, value});
    };
    for (int second = 0; second <= 95; ++second) {
        const int up = std::min(std::max(second - 10, 0), 32);
        const int down = std::min(std::max(second - 57, 0), 31);
        const double celsius = -32.0 + 10.0 * (up - down);
        hot.points.emplace_back(second, celsius);
        set(second, "tc1_celsius", celsius);
        if (second == 46 || second == 55) {
            set(second, "tc1_open", second == 46 ? 1.0 : 0.0);
        }
    }
    input.frames.push_back(parse_candump_line("(0.100000) can0 000#0100", "ramp"));
    input.until = Instant{95000000};
    std::ostringstream log;
    const auto device = ax188001::make_simulation();
    replay(*device, input, log, nullptr);
    std::istringstream lines{log.str()};
    for (const LoggedFrame& one : read_candump_log(lines, "ramp")) {
        const double seconds = static_cast<double>(one.time.us) / 1e6;
        if (one.frame.id == 0x1FFU) {
            shown.points.emplace_back(seconds, to_celsius(static_cast<std::int16_t>(read_u16(one.frame.payload(), 0))));
        } else if (one.frame.id == 0x0FFU) {
            plot.marks.push_back({seconds, fmt::format("{} {:.3f}", emergency_word(one.frame), seconds)});
        }
    }
    plot.curves = {hot, shown};
    return plot;
}

}  // namespace canproof::ax188001
