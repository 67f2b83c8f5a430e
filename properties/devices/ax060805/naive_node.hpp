// SPDX-License-Identifier: Apache-2.0
// Naive model of an AX060805 on the bus, at node-ID 127: the naive inclinometer, errors and emergency messages, NMT
// states, the time-out of RPDO1 and the transmission times of the TPDOs. Shares no code with the firmware.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <deque>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "properties/devices/ax060805/naive_inclinometer.hpp"

namespace canproof::test {

/// The active errors (section 4.2.4) and their emergency messages.
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

/// The frames that the node has sent: how often it sent each TPDO, and all other frames as text (`messages`).
struct NaiveSaid {
    std::vector<std::string> messages;
    std::array<int, 3> process_data{};
};

class NaiveNode {
  public:
    NaiveNode(const NaiveUnit& unit, const NaiveFelt& felt)
        : unit_{unit}, felt_{felt}, inclinometer_{unit, felt, NaiveEntries{}} {
        said_.messages.push_back("77F#00");
        tell_sensor_errors();
    }

    /// Returns false when a result of the device depends on rounding in single precision, because a value is very near
    /// to a threshold.
    bool is_certain() const { return !inclinometer_.is_doubtful(); }
    const NaiveInclinometer& inclinometer() const { return inclinometer_; }
    const NaiveErrors& errors() const { return errors_; }
    bool is_operational() const { return operational_; }
    NaiveSaid take_said() {
        take_messages();
        return std::exchange(said_, {});
    }

    /// Sets the inputs; they apply from the next sample on.
    void feel(const NaiveFelt& felt) {
        felt_ = felt;
        inclinometer_.feel(felt);
    }
    void lose_frames(bool lost) {
        lost_ = lost;
        errors_.set(0x8110, lost);
    }
    void set(unsigned index, unsigned sub, double value) {
        const bool is_news = inclinometer_.entry(index, sub) != value;
        const bool taken = inclinometer_.write(index, sub, value);
        if (index == 0x1400) {
            watches_ = false;  // a write to 1400h ends the monitoring of the RPDO, and the errors of this RPDO
            errors_.set(0x8250, false);
            errors_.set(0x8210, false);
        }
        if (index == 0x1003) {
            errors_.clear_list();
        }
        for (unsigned n = 0; n < 3; ++n) {
            if (index == 0x1800 + n && operational_ && is_news) {
                due_[n] = value == 0.0 ? never_due : ms_ + static_cast<std::uint64_t>(value);
            }
        }
        take_messages();
        const std::string at = fmt::format("{:02X}{:02X}{:02X}", index % 256U, index / 256U, sub);
        said_.messages.push_back(taken ? "5FF#60" + at + "00000000" : "5FF#80" + at + "22000008");
    }
    /// Receives RPDO1 with `length` bytes.
    void receive_values(const std::array<int, 3>& values, unsigned length) {
        if (operational_ && length < 6) {
            errors_.set(0x8210, true);
        } else if (operational_) {
            watches_ = inclinometer_.entry(0x1400, 5) != 0.0;
            late_at_ = ms_ + static_cast<std::uint64_t>(inclinometer_.entry(0x1400, 5));
            errors_.set(0x8210, false);
            errors_.set(0x8250, false);
            for (std::size_t i = 0; i < 3; ++i) {
                inclinometer_.write(0x2500, static_cast<unsigned>(i) + 1U, values[i]);
            }
        }
    }
    /// Handles an NMT command: enters operational if `starts` is true, else pre-operational.
    void command(bool starts) { go(starts); }
    /// Stores all parameters by 1010h:1 (store parameters).
    void store() {
        stored_ = inclinometer_.parameters();
        set(0x1010, 1, 1702257011.0);  // the signature `save` as a number
    }
    /// Restarts the node with the stored parameters. Called at reset node and at power-on.
    void restart() {
        begun_ = ms_;
        inclinometer_ = NaiveInclinometer{unit_, felt_, stored_};
        errors_ = NaiveErrors{};
        operational_ = false;
        watches_ = false;
        said_.messages.push_back("77F#00");
        errors_.set(0x8110, lost_);
        tell_sensor_errors();
    }
    /// Lets one millisecond pass.
    void pass() {
        ++ms_;
        inclinometer_.run_to(ms_ - begun_);
        if ((ms_ - begun_) % 5U == 0U) {
            tell_sensor_errors();
        }
        if (watches_ && late_at_ == ms_) {
            watches_ = false;
            errors_.set(0x8250, true);
            inclinometer_.forget_received();
            go(operational_ && inclinometer_.entry(0x1029, 1) != 0.0);
        }
        send_due();
    }

  private:
    static constexpr std::uint64_t never_due = ~std::uint64_t{0};

    void tell_sensor_errors() {
        tell_sensor_error(0x4200, inclinometer_.has_temperature_error());
        tell_sensor_error(0xFF00, inclinometer_.has_sensor_error());
    }
    /// Reports a sensor error. When an error begins, the node leaves operational, unless 1029h:2 (error behaviour) is 1
    /// (no change of state).
    void tell_sensor_error(unsigned code, bool lasts) {
        const bool begins = lasts && !errors_.lasts(code);
        errors_.set(code, lasts);
        if (begins) {
            go(operational_ && inclinometer_.entry(0x1029, 2) != 0.0);
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
    std::uint64_t period(unsigned n) const { return static_cast<std::uint64_t>(inclinometer_.entry(0x1800 + n, 5)); }
    void send_due() {
        for (unsigned n = 0; n < 3 && operational_; ++n) {
            if (due_[n] == ms_) {
                due_[n] = ms_ + period(n);
                ++said_.process_data[n];
            }
        }
    }
    void take_messages() {
        said_.messages.insert(said_.messages.end(), errors_.messages.begin(), errors_.messages.end());
        errors_.messages.clear();
    }

    NaiveUnit unit_;
    NaiveFelt felt_;
    NaiveEntries stored_;
    NaiveInclinometer inclinometer_;
    NaiveErrors errors_;
    NaiveSaid said_;
    std::uint64_t ms_{0};
    std::uint64_t begun_{0};  ///< time of the last power-on or reset
    bool operational_{false};
    bool lost_{false};     ///< whether the CAN controller loses received frames at present (overrun)
    bool watches_{false};  ///< whether RPDO1 is monitored: it was received since the last event that ends the
                           ///< monitoring
    std::uint64_t late_at_{0};
    std::array<std::uint64_t, 3> due_{never_due, never_due, never_due};
};

}  // namespace canproof::test
