// SPDX-License-Identifier: Apache-2.0
// Runs an AX060805 and its naive model with the same inputs, frames and writes, and compares them.
#pragma once

#include <fmt/format.h>
#include <rapidcheck.h>

#include <cstring>
#include <memory>
#include <vector>

#include "firmware/base/time.hpp"
#include "host/sim/devices/memory.hpp"
#include "properties/devices/ax060805/naive_comparison.hpp"

namespace canproof::test {

/// One write by SDO. `bytes` is the length of the value if it is an integer, or 0 if it is a REAL32.
struct Setting {
    std::uint16_t index{0};
    std::uint8_t sub{0};
    int bytes{1};
    double value{0.0};
};

class TwoInclinometers {
  public:
    explicit TwoInclinometers(const NaiveUnit& unit) : node_{unit, NaiveFelt{}} {
        ax060805::FactoryData factory;
        factory.calibration = {static_cast<float>(unit.calibration.pitch), static_cast<float>(unit.calibration.roll)};
        factory.range = static_cast<ax060805::AngleConfiguration>(unit.range);
        device_ = std::make_unique<ax060805::Device>(memory_, queue_, factory);
        device_->power_on(inputs_, Instant{});
        compare_frames();
    }

    bool is_certain() const { return node_.is_certain(); }

    void feel(const NaiveFelt& felt) {
        inputs_.acceleration_x = static_cast<float>(felt.acceleration.x);
        inputs_.acceleration_y = static_cast<float>(felt.acceleration.y);
        inputs_.acceleration_z = static_cast<float>(felt.acceleration.z);
        inputs_.accelerometer_fault = felt.fault;
        inputs_.sensor_temperature = static_cast<float>(felt.sensor_temperature);
        inputs_.processor_temperature = static_cast<float>(felt.processor_temperature);
        inputs_.supply_voltage = static_cast<float>(felt.supply);
        node_.feel(felt);
        RC_LOG() << fmt::format("{} ms: {} {} {} g, fault {}, {} C, {} C, {} V\n", ms_, felt.acceleration.x,
                                felt.acceleration.y, felt.acceleration.z, felt.fault, felt.sensor_temperature,
                                felt.processor_temperature, felt.supply);
        device_->set_inputs(inputs_, now());
        pass(5);  // the next sample, at most 5 ms later, detects an error
    }
    void lose_frames(bool lost) {
        inputs_.can_overrun = lost;
        device_->set_inputs(inputs_, now());
        node_.lose_frames(lost);
        compare_frames();
    }
    void set(const Setting& setting) {
        hear(download(setting));
        node_.set(setting.index, setting.sub, setting.value);
        compare_frames();
    }
    void send_values(const std::array<int, 3>& values, std::uint8_t length) {
        Frame frame = data_frame(0x27FU, length);
        for (std::size_t i = 0; i < 3; ++i) {
            write_le(MutableBytes{frame.data}, 2U * i, 2U, static_cast<std::uint32_t>(values[i]) & 0xFFFFU);
        }
        hear(frame);
        node_.receive_values(values, length);
        compare_frames();
    }
    void command(std::uint8_t command) {
        Frame frame = data_frame(0U, 2U);
        frame.data[0] = command;
        hear(frame);
        node_.command(command == 0x01);
        compare_frames();
    }
    /// Stores all parameters by 1010h:1 (store parameters).
    void store() {
        hear(download({0x1010, 1, 4, 1702257011.0}));
        node_.store();
        compare_frames();
    }
    /// Sends the NMT command reset node, after which device and model have the stored parameters.
    void reset() {
        Frame frame = data_frame(0U, 2U);
        frame.data[0] = 0x81;
        hear(frame);
        node_.restart();
        compare_frames();
    }
    void clear_list() { set({0x1003, 0, 1, 0.0}); }

    void pass(std::uint64_t ms) {
        for (; ms > 0; --ms) {
            ++ms_;
            node_.pass();
            while (device_->next_deadline() <= now()) {
                device_->advance(now());
            }
            compare_frames();
        }
    }

    /// Compares every value of the dictionary that the device measures or computes.
    void check() const {
        const NaiveComparison<decltype(&demand)> comparison{*device_, node_, demand_};
        comparison.values();
        comparison.errors();
    }

  private:
    static void demand(bool holds, const char* what, unsigned index) {
        if (!holds) {
            RC_FAIL(fmt::format("{} ({:04X}h)", what, index));
        }
    }

    Instant now() const { return Instant{ms_ * 1000U}; }
    void hear(const Frame& frame) {
        RC_LOG() << fmt::format("{} ms: {}\n", ms_, host::format_frame(frame));
        device_->receive(frame, now());
    }
    static Frame download(const Setting& setting) {
        Frame frame = data_frame(0x67FU, 8U);
        const int bytes = setting.bytes == 0 ? 4 : setting.bytes;
        const auto real = static_cast<float>(setting.value);
        auto number = static_cast<std::uint32_t>(static_cast<std::int64_t>(setting.value));
        if (setting.bytes == 0) {
            std::memcpy(&number, &real, sizeof number);
        }
        frame.data[0] = static_cast<std::uint8_t>(0x23 + 4 * (4 - bytes));
        write_le(MutableBytes{frame.data}, 1U, 2U, setting.index);
        frame.data[3] = setting.sub;
        for (int i = 0; i < bytes; ++i) {
            frame.data[static_cast<std::size_t>(4 + i)] = static_cast<std::uint8_t>(number >> (8 * i) & 0xFFU);
        }
        return frame;
    }
    void compare_frames() {
        std::vector<Frame> frames;
        while (!queue_.empty()) {
            frames.push_back(queue_.pop());
        }
        NaiveComparison<decltype(&demand)>{*device_, node_, demand_}.frames(frames, node_.take_said());
    }

    host::Memory memory_{4096};
    TransmitQueue queue_;
    ax060805::Inputs inputs_{};
    std::unique_ptr<ax060805::Device> device_;
    NaiveNode node_;
    std::uint64_t ms_{0};
    void (*const demand_)(bool, const char*, unsigned){demand};
};

}  // namespace canproof::test
