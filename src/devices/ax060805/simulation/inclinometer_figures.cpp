// SPDX-License-Identifier: Apache-2.0
#include "devices/ax060805/simulation/inclinometer_figures.hpp"

#include <array>
#include <cmath>

#include "devices/ax060805/firmware/tilt.hpp"
#include "devices/ax060805/simulation/simulation.hpp"
#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/sim/bus/candump.hpp"

namespace canproof::ax060805 {

using namespace host;

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double turn_seconds = 20.0;
constexpr double tumble_seconds = 3.0 * turn_seconds;
constexpr double counts_per_degree = 50.0;  // 1/50 degree per count: 180 degrees are 9000 counts

struct Quaternion {
    double w, x, y, z;
};

/// Returns the attitude `seconds` after the tumble began.
Quaternion attitude_at(double seconds) {
    const int turn = seconds < turn_seconds ? 0 : (seconds < 2.0 * turn_seconds ? 1 : 2);
    const double half_angle = pi * (seconds - turn * turn_seconds) / turn_seconds;
    const double along_x = turn == 0 ? 0.0 : (turn == 1 ? 1.0 : std::sqrt(0.5));
    const double along_y = turn == 0 ? 1.0 : (turn == 1 ? 0.0 : std::sqrt(0.5));
    return Quaternion{std::cos(half_angle), std::sin(half_angle) * along_x, std::sin(half_angle) * along_y, 0.0};
}

/// A simulated AX060805 that sends TPDO1 every 20 ms, with angles in units of 1/50 degree.
class Bench {
  public:
    Bench() : device_{ax060805::make_simulation()} {
        device_->power_on(now_);
        for (const char* request :
             {"67F#2B30200132000000", "67F#2B30200232000000", "67F#2B30200332000000", "67F#2B00180514000000"}) {
            tell(request);
        }
    }
    void tell(const std::string& frame) {
        device_->receive(parse_frame(frame, "figure"), now_);
        take_angles();
    }
    void start() { tell("000#0100"); }
    void set(const std::string& input, double value) { device_->set_input(input, value, now_); }
    void pass(double seconds) {
        const Instant end = now_ + microseconds(static_cast<std::uint64_t>(std::llround(seconds * 1.0e6)));
        while (device_->next_deadline() <= end) {
            now_ = device_->next_deadline() < now_ ? now_ : device_->next_deadline();
            device_->advance(now_);
            take_angles();
        }
        now_ = end;
    }
    double seconds() const { return static_cast<double>(now_.us) / 1.0e6; }
    /// Returns pitch, roll and gravity angle in degrees from the latest TPDO1.
    const std::array<double, 3>& angles() const { return angles_; }

  private:
    void take_angles() {
        while (!device_->queue().empty()) {
            const Frame frame = device_->queue().pop();
            for (std::size_t i = 0; frame.id == 0x1FFU && i < angles_.size(); ++i) {
                angles_[i] = static_cast<std::int16_t>(read_u16(frame.payload(), 2 * i)) / counts_per_degree;
            }
        }
    }

    std::unique_ptr<SimulatedDevice> device_;
    Instant now_{};
    std::array<double, 3> angles_{};
};

std::vector<PlotMark> marks_of_turns() {
    return {{turn_seconds, "about X"}, {2.0 * turn_seconds, "about both"}};
}

LinePlot tumble(const char* title, bool euler) {
    Bench bench;
    if (euler) {
        bench.tell("67F#2F00210000000000");
    }
    bench.tell("67F#2F03200032000000");  // 50 Hz: the delay of the filter is smaller than the line width of the plot
    bench.start();
    LinePlot plot{
        title, "time / s", "angle / degrees", {{"pitch", {}}, {"roll", {}}, {"gravity angle", {}}}, marks_of_turns()};
    constexpr double step = 0.05;
    const int steps = static_cast<int>(tumble_seconds / step);
    for (int i = 0; i <= steps; ++i) {
        const Quaternion attitude = attitude_at(i * step);
        bench.set("attitude_w", attitude.w);
        bench.set("attitude_x", attitude.x);
        bench.set("attitude_y", attitude.y);
        bench.set("attitude_z", attitude.z);
        bench.pass(step);
        for (std::size_t angle = 0; angle < plot.curves.size(); ++angle) {
            plot.curves[angle].points.emplace_back(i * step, bench.angles()[angle]);
        }
    }
    return plot;
}

/// Returns gravity in the frame of reference of a unit in this attitude.
std::array<double, 3> gravity_at(const Quaternion& q) {
    return {2.0 * (q.x * q.z - q.w * q.y), 2.0 * (q.y * q.z + q.w * q.x), 1.0 - 2.0 * (q.x * q.x + q.y * q.y)};
}

double degrees(double y, double x) {
    return std::atan2(y, x) * 180.0 / pi;
}

}  // namespace

LinePlot tumble_plot() {
    return tumble("AX060805: a tumble through all orientations, tilt angles", false);
}

LinePlot euler_tumble_plot() {
    return tumble("AX060805: the same tumble, Euler angles", true);
}

LinePlot angle_error_plot() {
    LinePlot plot{"AX060805: error of single precision against double precision",
                  "time of the tumble / s",
                  "error / millionths of a degree",
                  {{"pitch", {}}, {"roll", {}}, {"gravity angle", {}}},
                  marks_of_turns()};
    constexpr int steps = 3001;
    for (int i = 0; i <= steps; ++i) {
        const double seconds = tumble_seconds * i / steps;
        const auto exact = gravity_at(attitude_at(seconds));
        const Vector3 single{static_cast<float>(exact[0]), static_cast<float>(exact[1]), static_cast<float>(exact[2])};
        // Both computations use the same acceleration as input.
        const double x = static_cast<double>(single.x);
        const double y = static_cast<double>(single.y);
        const double z = static_cast<double>(single.z);
        const double side = z < 0.0 ? -1.0 : 1.0;
        const PitchRoll tilt = tilt_angles(single);
        const std::array<double, 3> errors{
            static_cast<double>(tilt.pitch) - degrees(-x, side * std::sqrt(y * y + z * z)),
            static_cast<double>(tilt.roll) - degrees(y, side * std::sqrt(x * x + z * z)),
            static_cast<double>(gravity_angle(single)) - degrees(std::sqrt(x * x + y * y), z)};
        for (std::size_t angle = 0; angle < errors.size(); ++angle) {
            // -180 and 180 are the same direction
            plot.curves[angle].points.emplace_back(seconds, std::remainder(errors[angle], 360.0) * 1.0e6);
        }
    }
    return plot;
}

LinePlot settling_plot() {
    LinePlot plot{"AX060805: settling of the input filter after a step of 30 degrees",
                  "time / s",
                  "pitch / degrees",
                  {},
                  {{0.2, "0.2 s: 95 % at 5 Hz"}}};
    constexpr double step = 0.02;
    for (const int cut_off : {1, 5, 50}) {
        Bench bench;
        bench.tell("67F#2F032000" + std::string{cut_off == 1 ? "01" : (cut_off == 5 ? "05" : "32")} + "000000");
        bench.start();
        Curve curve{std::to_string(cut_off) + " Hz", {{0.0, 0.0}}};
        bench.set("pitch", 30.0);
        while (bench.seconds() < 0.8) {
            bench.pass(step);
            curve.points.emplace_back(bench.seconds(), bench.angles()[0]);
        }
        plot.curves.push_back(std::move(curve));
    }
    return plot;
}

}  // namespace canproof::ax060805
