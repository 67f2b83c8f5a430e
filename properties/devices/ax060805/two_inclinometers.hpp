// SPDX-License-Identifier: Apache-2.0
// Runs an AX060805 and its naive model with the same inputs, frames and writes. Compares every frame and every value,
// as long as rounding in single precision does not decide a result.
#pragma once

#include <fmt/format.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <deque>
#include <set>
#include <vector>

#include "devices/ax060805/firmware/ax060805.hpp"
#include "firmware/base/time.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/devices/memory.hpp"
#include "properties/devices/ax060805/naive_inclinometer.hpp"

namespace canproof::test {

/// A write by SDO. `bytes` is the length of an integer, or 0 for a REAL32.
struct Setting {
    std::uint16_t index{0};
    std::uint8_t sub{0};
    int bytes{1};
    double value{0.0};
};

/// The errors of 4.2.4 and their emergency messages.
class NaiveErrors {
  public:
    void set(unsigned code, bool lasts) {
        if (lasts == (lasting_.count(code) != 0U)) {
            return;
        }
        if (lasts) {
            lasting_.insert(code);
            list_.push_front(code);
            list_.resize(std::min<std::size_t>(list_.size(), 4));
        } else {
            lasting_.erase(code);
            list_.erase(std::remove(list_.begin(), list_.end(), code), list_.end());
        }
        const unsigned told = lasts ? code : 0U;
        messages.push_back(
            fmt::format("0FF#{:02X}{:02X}{:02X}0000000000", told % 256U, told / 256U, lasting_.empty() ? 0 : 1));
    }
    void clear_list() { list_.clear(); }
    bool lasts(unsigned code) const { return lasting_.count(code) != 0U; }
    unsigned error_register() const { return lasting_.empty() ? 0U : 1U; }
    const std::deque<unsigned>& list() const { return list_; }

    std::vector<std::string> messages;

  private:
    std::set<unsigned> lasting_;
    std::deque<unsigned> list_;
};

class TwoInclinometers {
  public:
    explicit TwoInclinometers(const NaiveUnit& unit) : unit_{unit}, naive_{unit, NaiveFelt{}, {}} {
        ax060805::FactoryData factory;
        factory.calibration = {static_cast<float>(unit.calibration.pitch), static_cast<float>(unit.calibration.roll)};
        factory.range = static_cast<ax060805::AngleConfiguration>(unit.range);
        device_ = std::make_unique<ax060805::Device>(memory_, queue_, factory);
        device_->power_on(inputs_, Instant{});
        expected_.push_back("77F#00");
        compare_frames();
    }

    /// Returns false when a value is so near to a threshold that rounding in single precision decides.
    bool is_certain() const { return !naive_.is_doubtful(); }

    void feel(const NaiveFelt& felt) {
        inputs_.acceleration_x = static_cast<float>(felt.acceleration.x);
        inputs_.acceleration_y = static_cast<float>(felt.acceleration.y);
        inputs_.acceleration_z = static_cast<float>(felt.acceleration.z);
        inputs_.accelerometer_fault = felt.fault;
        inputs_.sensor_temperature = static_cast<float>(felt.sensor_temperature);
        inputs_.processor_temperature = static_cast<float>(felt.processor_temperature);
        inputs_.supply_voltage = static_cast<float>(felt.supply);
        felt_ = felt;
        naive_.feel(felt);
        RC_LOG() << fmt::format("{} ms: {} {} {} g, fault {}, {} C, {} C, {} V\n", ms_, felt.acceleration.x,
                                felt.acceleration.y, felt.acceleration.z, felt.fault, felt.sensor_temperature,
                                felt.processor_temperature, felt.supply);
        device_->set_inputs(inputs_, now());
        pass(5);  // the device detects the error with the next sample
    }
    void lose_frames(bool lost) {
        inputs_.can_overrun = lost;
        device_->set_inputs(inputs_, now());
        errors_.set(0x8110, lost);
        compare_frames();
    }
    void set(const Setting& setting) {
        const bool is_news = naive_.entry(setting.index, setting.sub) != setting.value;
        const bool taken = naive_.write(setting.index, setting.sub, setting.value);
        if (setting.index == 0x1400) {
            watches_ = false;  // this also ends the errors that the RPDO raised
            errors_.set(0x8250, false);
            errors_.set(0x8210, false);
        }
        if (setting.index == 0x1003) {
            errors_.clear_list();
        }
        for (unsigned n = 0; n < 3; ++n) {
            if (setting.index == 0x1800 + n && operational_ && is_news) {
                due_[n] = setting.value == 0.0 ? never_due : ms_ + static_cast<std::uint64_t>(setting.value);
            }
        }
        hear(download(setting));
        const std::string at =
            fmt::format("{:02X}{:02X}{:02X}", setting.index % 256U, setting.index / 256U, setting.sub);
        take_messages();
        expected_.push_back(taken ? "5FF#60" + at + "00000000" : "5FF#80" + at + "22000008");
        compare_frames();
    }
    void send_values(const std::array<int, 3>& values, std::uint8_t length) {
        Frame frame = data_frame(0x27FU, length);
        for (std::size_t i = 0; i < 3; ++i) {
            write_le(MutableBytes{frame.data}, 2U * i, 2U, static_cast<std::uint32_t>(values[i]) & 0xFFFFU);
        }
        hear(frame);
        if (operational_ && length < 6) {
            errors_.set(0x8210, true);
        } else if (operational_) {
            watches_ = naive_.entry(0x1400, 5) != 0.0;
            late_at_ = ms_ + static_cast<std::uint64_t>(naive_.entry(0x1400, 5));
            errors_.set(0x8210, false);
            errors_.set(0x8250, false);
            for (std::size_t i = 0; i < 3; ++i) {
                naive_.write(0x2500, static_cast<unsigned>(i) + 1U, values[i]);
            }
        }
        compare_frames();
    }
    void command(std::uint8_t command) {
        Frame frame = data_frame(0U, 2U);
        frame.data[0] = command;
        hear(frame);
        go(command == 0x01);
        compare_frames();
    }
    /// Stores all parameters by 1010h:1.
    void store() {
        stored_ = naive_.parameters();
        set({0x1010, 1, 4, 1702257011.0});  // the signature `save` as a number
    }
    /// Resets the node by NMT; the node starts with the stored parameters.
    void reset() {
        lose_frames(false);
        Frame frame = data_frame(0U, 2U);
        frame.data[0] = 0x81;
        hear(frame);
        begun_ = ms_;
        naive_ = NaiveInclinometer{unit_, felt_, stored_};
        errors_ = NaiveErrors{};
        operational_ = false;
        watches_ = false;
        expected_.push_back("77F#00");
        tell_sensor_errors();
        compare_frames();
    }
    void clear_list() { set({0x1003, 0, 1, 0.0}); }

    void pass(std::uint64_t ms) {
        for (; ms > 0; --ms) {
            ++ms_;
            naive_.run_to(ms_ - begun_);
            if ((ms_ - begun_) % 5U == 0U) {
                tell_sensor_errors();
            }
            if (watches_ && late_at_ == ms_) {
                watches_ = false;
                errors_.set(0x8250, true);
                naive_.forget_received();
                go(operational_ && naive_.entry(0x1029, 1) != 0.0);
            }
            while (device_->next_deadline() <= now()) {
                device_->advance(now());
            }
            send_due();
            compare_frames();
        }
    }

    /// Compares every value of the dictionary that the device measures or computes.
    void check() {
        if (!is_certain()) {
            return;
        }
        for (std::uint8_t i = 0; i < 3; ++i) {
            RC_ASSERT(holds(0x4000, static_cast<std::uint8_t>(i + 1U), naive_.acceleration_counts(i)));
            RC_ASSERT(holds(static_cast<std::uint16_t>(0x4030 + 0x10 * i), 0, naive_.angle_counts(i)));
        }
        for (std::uint8_t i = 0; i < 10; ++i) {
            RC_ASSERT(holds(0x3000, static_cast<std::uint8_t>(i + 1U), naive_.function_counts(i)));
        }
        RC_ASSERT(std::fabs(read(0x4010) - std::min(naive_.latency(), 65535.0)) <= 0.5001);
        RC_ASSERT(read(0x4020) == static_cast<std::uint32_t>(naive_.figure_of_merit()));
        RC_ASSERT(holds(0x4060, 0, naive_point(naive_.sensor_temperature())));
        RC_ASSERT(real(0x5020) == naive_.supply());
        RC_ASSERT(real(0x5030) == naive_.processor_temperature());
        for (const std::uint16_t mount : {std::uint16_t{0x2200}, std::uint16_t{0x2210}}) {
            RC_ASSERT(std::fabs(real(mount) - naive_.entry(mount)) < 0.001);
        }
        RC_ASSERT(read(0x2300) == 0U);
        RC_ASSERT(read(0x1001) == errors_.error_register());
        RC_ASSERT(read(0x1003) == errors_.list().size());
        for (std::uint8_t i = 0; i < errors_.list().size(); ++i) {
            RC_ASSERT(read(0x1003, static_cast<std::uint8_t>(i + 1U)) == errors_.list()[i]);
        }
        RC_ASSERT((device_->state() == NmtState::operational) == operational_);
    }

  private:
    static constexpr std::uint64_t never_due = ~std::uint64_t{0};

    Instant now() const { return Instant{ms_ * 1000U}; }
    void hear(const Frame& frame) {
        RC_LOG() << fmt::format("{} ms: {}\n", ms_, host::format_frame(frame));
        device_->receive(frame, now());
    }
    std::uint32_t read(std::uint16_t index, std::uint8_t sub = 0) const { return device_->objects().read(index, sub); }
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
    bool holds(std::uint16_t index, std::uint8_t sub, const NaiveSpan& span) const {
        return is_one_of(static_cast<std::int16_t>(read(index, sub)), span);
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

    void tell_sensor_errors() {
        tell_sensor_error(0x4200, naive_.has_temperature_error());
        tell_sensor_error(0xFF00, naive_.has_sensor_error());
    }
    /// Reports a sensor error; it ends operational unless 1029h:2 (error behaviour) is 1.
    void tell_sensor_error(unsigned code, bool lasts) {
        const bool begins = lasts && !errors_.lasts(code);
        errors_.set(code, lasts);
        if (begins) {
            go(operational_ && naive_.entry(0x1029, 2) != 0.0);
        }
    }
    void go(bool operational) {
        if (operational && !operational_) {
            for (unsigned n = 0; n < 3; ++n) {
                due_[n] = period(n) == 0U ? never_due : ms_;
            }
        }
        watches_ = watches_ && operational;
        operational_ = operational;
        send_due();
    }
    std::uint64_t period(unsigned n) const {
        const double set = naive_.entry(0x1800 + n, 5);
        return static_cast<std::uint64_t>(set);
    }
    void send_due() {
        for (unsigned n = 0; n < 3 && operational_; ++n) {
            if (due_[n] == ms_) {
                due_[n] = ms_ + period(n);
                ++process_data_[n];
            }
        }
    }

    void take_messages() {
        expected_.insert(expected_.end(), errors_.messages.begin(), errors_.messages.end());
        errors_.messages.clear();
    }
    void compare_frames() {
        take_messages();
        std::vector<std::string> got;
        std::array<int, 3> sent{};
        while (!queue_.empty()) {
            const Frame frame = queue_.pop();
            const bool is_process_data = frame.id == 0x1FFU || frame.id == 0x2FFU || frame.id == 0x3FFU;
            if (is_process_data) {
                ++sent[frame.id / 0x100U - 1U];
                check_values(frame);
            } else {
                got.push_back(host::format_frame(frame));
            }
        }
        if (is_certain()) {
            RC_ASSERT(got == expected_);
            RC_ASSERT(sent == process_data_);
        }
        expected_.clear();
        process_data_ = {};
    }
    void check_values(const Frame& frame) const {
        const auto count = [&](unsigned i) {
            return static_cast<std::int16_t>(frame.data[2U * i] + 256 * frame.data[2U * i + 1U]);
        };
        for (unsigned i = 0; i < 3 && frame.id != 0x3FFU && is_certain(); ++i) {
            RC_ASSERT(is_one_of(count(i), frame.id == 0x1FFU ? naive_.angle_counts(i) : naive_.acceleration_counts(i)));
        }
        if (frame.id == 0x1FFU) {
            RC_ASSERT(frame.length == 7);
            RC_ASSERT(!is_certain() || frame.data[6] == naive_.figure_of_merit());
        } else if (frame.id == 0x2FFU) {
            RC_ASSERT(is_one_of(count(3), naive_point(naive_.sensor_temperature())));
        } else {
            float values[2]{};
            std::memcpy(values, frame.data.data(), sizeof values);
            RC_ASSERT(static_cast<double>(values[0]) == naive_.supply());
            RC_ASSERT(static_cast<double>(values[1]) == naive_.processor_temperature());
        }
    }

    host::Memory memory_{4096};
    TransmitQueue queue_;
    ax060805::Inputs inputs_{};
    std::unique_ptr<ax060805::Device> device_;
    NaiveUnit unit_;
    NaiveFelt felt_;
    NaiveEntries stored_;
    NaiveInclinometer naive_;
    NaiveErrors errors_;
    std::uint64_t ms_{0};
    std::uint64_t begun_{0};  ///< time of the last power-on or reset
    bool operational_{false};
    bool watches_{false};  ///< the RPDO was received and has been monitored since
    std::uint64_t late_at_{0};
    std::array<std::uint64_t, 3> due_{never_due, never_due, never_due};
    std::vector<std::string> expected_;
    std::array<int, 3> process_data_{};
};

}  // namespace canproof::test
