// SPDX-License-Identifier: Apache-2.0
// Compares an AX060805 with its naive model, except where rounding in single precision decides a result. Calls
// `check(holds, what, index)` for each compared value.
#pragma once

#include <cmath>
#include <cstring>
#include <vector>

#include "devices/ax060805/firmware/ax060805.hpp"
#include "host/sim/bus/candump.hpp"
#include "properties/devices/ax060805/naive_node.hpp"

namespace canproof::test {

inline NaiveFelt felt_of(const ax060805::Inputs& inputs) {
    return {{static_cast<double>(inputs.acceleration_x), static_cast<double>(inputs.acceleration_y),
             static_cast<double>(inputs.acceleration_z)},
            inputs.accelerometer_fault,
            static_cast<double>(inputs.sensor_temperature),
            static_cast<double>(inputs.processor_temperature),
            static_cast<double>(inputs.supply_voltage)};
}

template <typename Check>
class NaiveComparison {
  public:
    NaiveComparison(const ax060805::Device& device, const NaiveNode& node, const Check& check)
        : device_{device}, node_{node}, naive_{node.inclinometer()}, check_{check} {}

    /// Compares every value of the dictionary that the device measures or computes, and whether the node is
    /// operational.
    void values() const {
        if (!node_.is_certain()) {
            return;
        }
        for (std::uint8_t i = 0; i < 3; ++i) {
            expect(0x4000, static_cast<std::uint8_t>(i + 1U), naive_.acceleration_counts(i));
            expect(static_cast<std::uint16_t>(0x4030 + 0x10 * i), 0, naive_.angle_counts(i));
        }
        for (std::uint8_t i = 0; i < 10; ++i) {
            expect(0x3000, static_cast<std::uint8_t>(i + 1U), naive_.function_counts(i));
        }
        check_(std::fabs(read(0x4010) - std::min(naive_.latency(), 65535.0)) <= 0.5001, "latency", 0x4010U);
        check_(read(0x4020) == static_cast<std::uint32_t>(naive_.figure_of_merit()), "figure of merit", 0x4020U);
        expect(0x4060, 0, naive_point(naive_.sensor_temperature()));
        check_(real(0x5020) == naive_.supply(), "supply", 0x5020U);
        check_(real(0x5030) == naive_.processor_temperature(), "processor temperature", 0x5030U);
        for (const std::uint16_t mount : {std::uint16_t{0x2200}, std::uint16_t{0x2210}}) {
            check_(std::fabs(real(mount) - naive_.entry(mount)) < 0.001, "initial angle", mount);
        }
        check_(read(0x2300) == 0U, "Auto-Null", 0x2300U);
        check_((device_.state() == NmtState::operational) == node_.is_operational(), "state of the node", 0U);
    }
    void errors() const {
        const NaiveErrors& errors = node_.errors();
        if (!node_.is_certain()) {
            return;
        }
        check_(read(0x1001) == errors.error_register(), "error register", 0x1001U);
        check_(read(0x1003) == errors.list().size(), "number of errors", 0x1003U);
        for (std::uint8_t i = 0; i < errors.list().size(); ++i) {
            check_(read(0x1003, static_cast<std::uint8_t>(i + 1U)) == errors.list()[i], "error list", 0x1003U);
        }
    }
    /// Compares the frames that the device has sent at one moment with the frames that the model sends at this moment.
    void frames(const std::vector<Frame>& frames, const NaiveSaid& expected) const {
        NaiveSaid said;
        for (const Frame& frame : frames) {
            if (frame.id == 0x1FFU || frame.id == 0x2FFU || frame.id == 0x3FFU) {
                ++said.process_data[frame.id / 0x100U - 1U];
                process_data(frame);
            } else {
                said.messages.push_back(host::format_frame(frame));
            }
        }
        if (node_.is_certain()) {
            check_(said.messages == expected.messages, "the messages", 0U);
            check_(said.process_data == expected.process_data, "the TPDOs that are due", 0U);
        }
    }

  private:
    void process_data(const Frame& frame) const {
        const auto count = [&](unsigned i) {
            return static_cast<std::int16_t>(frame.data[2U * i] + 256 * frame.data[2U * i + 1U]);
        };
        if (!node_.is_certain()) {
            return;
        }
        for (unsigned i = 0; i < 3 && frame.id != 0x3FFU; ++i) {
            check_(is_one_of(count(i), frame.id == 0x1FFU ? naive_.angle_counts(i) : naive_.acceleration_counts(i)),
                   "contents of a TPDO", frame.id);
        }
        if (frame.id == 0x1FFU) {
            check_(frame.length == 7 && frame.data[6] == naive_.figure_of_merit(), "figure of merit", frame.id);
        } else if (frame.id == 0x2FFU) {
            check_(is_one_of(count(3), naive_point(naive_.sensor_temperature())), "temperature", frame.id);
        } else {
            float values[2]{};
            std::memcpy(values, frame.data.data(), sizeof values);
            check_(static_cast<double>(values[0]) == naive_.supply(), "supply", frame.id);
            check_(static_cast<double>(values[1]) == naive_.processor_temperature(), "processor temperature", frame.id);
        }
    }
    std::uint32_t read(std::uint16_t index, std::uint8_t sub = 0) const { return device_.objects().read(index, sub); }
    double real(std::uint16_t index) const {
        const std::uint32_t bits = read(index);
        float value = 0.0F;
        std::memcpy(&value, &bits, sizeof value);
        return static_cast<double>(value);
    }
    static double rounded(double counts) { return std::round(std::max(-32768.0, std::min(32767.0, counts))); }
    static bool is_one_of(int count, const NaiveSpan& span) {
        return rounded(span.low) <= count && count <= rounded(span.high);
    }
    void expect(std::uint16_t index, std::uint8_t sub, const NaiveSpan& span) const {
        check_(is_one_of(static_cast<std::int16_t>(read(index, sub)), span), "value", index);
    }

    const ax060805::Device& device_;
    const NaiveNode& node_;
    const NaiveInclinometer& naive_;
    const Check& check_;
};

}  // namespace canproof::test
