// SPDX-License-Identifier: Apache-2.0
// Naive measurement of the AX188001 (manual, 1.1 to 1.4, 3.3, 3.4). It stores only the last reading and the faults, and
// computes all other values again at each evaluation. Shares no code with the firmware.
#pragma once

#include <functional>
#include <optional>

#include "properties/devices/ax188001/naive_parameters.hpp"
#include "properties/devices/ax188001/naive_thermocouple.hpp"

namespace canproof::naive_tcs {

struct Terminals {
    std::array<float, 2> uv{};
    std::array<bool, 2> open{};
    std::array<float, 2> hum_uv{};
    unsigned mains_hz{0};
    float cold_junction_c{25.0F};
    float cpu_c{35.0F};
    float supply_v{24.0F};
    bool overrun{false};
    unsigned can{0};  ///< state of the CAN controller: 0 error active, 1 warning, 2 error passive, 3 bus-off
};

/// A fault that is reported when it has lasted for its delay. The end of the fault is reported at once (sections
/// 3.4.16, 3.4.21).
struct Fault {
    std::optional<std::uint64_t> since;
    bool told{false};

    void judge(bool begins, bool ends, unsigned delay_ms, std::uint64_t now) {
        if (told) {
            told = !ends;
        } else if (!begins) {
            since.reset();
        } else {
            since = since ? since : now;
            expire(delay_ms, now);
        }
    }
    void expire(unsigned delay_ms, std::uint64_t now) {
        if (since && now >= *since + delay_ms) {
            *this = Fault{std::nullopt, true};
        }
    }
};

/// The faults of a channel in the order in which they are reported.
enum ChannelFault : unsigned { open_circuit, high_warning, low_warning, shutdown };

struct Shown {
    double uv{0.0};  ///< thermocouple voltage before it is rounded for 2010h (TC Input Microvolts)
    float celsius{0.0F};
    bool valid{false};
    std::int16_t process{0};
};

class Scanner {
  public:
    /// Returns the temperature (REAL32) that the device shows for a channel. The model computes in double precision and
    /// takes the last digits from the device.
    using Observe = std::function<float(unsigned channel)>;

    explicit Scanner(Observe observe) : observe_{std::move(observe)} {}

    /// Lets the converters settle on the voltage at the terminals. That takes nine readings: one at the highest gain,
    /// and four after each of at most two changes to a lower gain.
    void restart(const Application& all, const Terminals& at) {
        *this = Scanner{observe_};
        for (int reading = 0; reading < 9; ++reading) {
            read(all, at);
        }
    }
    void read(const Application& all, const Terminals& at) {
        for (std::size_t i = 0; i < 2; ++i) {
            const double left = static_cast<double>(at.hum_uv[i]) * hum_left(all.filter_hz, at.mains_hz);
            const double uv = static_cast<double>(at.uv[i]) + (hum_rises_ ? left : -left);
            converters_[i].read(at.open[i] ? std::numeric_limits<double>::infinity() : uv);
        }
        hum_rises_ = !hum_rises_;
        cold_junction_c_ = std::min(std::max(at.cold_junction_c, -40.0F), 110.0F);
        cpu_c_ = at.cpu_c;
        supply_v_ = at.supply_v;
    }
    void restart_filters() {
        for (Converter& one : converters_) {
            one.restart_filter();
        }
    }
    /// Computes values and faults from the last reading and the present parameters.
    void evaluate(const Application& all, std::uint64_t now) {
        for (std::size_t i = 0; i < 2; ++i) {
            evaluate_channel(i, all.channel[i], now);
        }
        const double temperature = fd_value(0);
        const double voltage = fd_value(1);
        judge_unit(0, all, temperature > all.fd_set[0], temperature <= all.fd_clear[0], now);
        judge_unit(1, all, voltage > all.fd_set[1], voltage <= all.fd_clear[1], now);
        judge_unit(2, all, voltage < all.fd_set[2], voltage >= all.fd_clear[2], now);
    }
    /// Marks the faults whose delay ends now as reported.
    void expire(const Application& all, std::uint64_t now) {
        for (std::size_t i = 0; i < 2; ++i) {
            for (Fault& one : faults[i]) {
                one.expire(all.channel[i].delay_ms, now);
            }
        }
        for (std::size_t i = 0; i < 3; ++i) {
            unit_faults[i].expire(all.fd_delay_ms[i == 0 ? 0 : 1], now);
        }
    }

    const Shown& shown(std::size_t channel) const { return shown_[channel]; }
    const Converter& converter(std::size_t channel) const { return converters_[channel]; }
    float cold_junction_c() const { return cold_junction_c_; }
    std::int16_t cold_junction_process(const Application& all) const {
        return scaled(cold_junction_c_, all.cj_factor, all.cj_offset);
    }
    /// Returns a fault detection value in tenths of a degree or of a volt (section 3.4.17).
    double fd_value(std::size_t which) const {
        return std::round(10.0 * static_cast<double>(which == 0 ? cpu_c_ : supply_v_));
    }
    /// Returns the average: the sum of the valid channels divided by their number (section 1.2).
    Shown average(const Application& all) const {
        double sum = 0.0;
        int count = 0;
        bool broken = false;
        for (std::size_t i = 0; i < 2; ++i) {
            sum += shown_[i].valid ? static_cast<double>(shown_[i].celsius) : 0.0;
            count += shown_[i].valid ? 1 : 0;
            broken = broken || (all.channel[i].enabled && converters_[i].open());
        }
        Shown mean;
        mean.valid = all.averages && count > 0;
        if (mean.valid) {
            mean.celsius = static_cast<float>(sum / count);
            mean.process = measured(mean.celsius, all.average_factor, all.average_offset);
        } else {
            mean.process = all.averages && broken ? open_value : disabled_value;
        }
        return mean;
    }
    /// Returns the status of a channel by Table 7. Of several conditions, the worst one determines the status.
    unsigned status(std::size_t channel) const {
        const auto& has = faults[channel];
        if (has[open_circuit].told) {
            return 0x05;
        }
        if (has[shutdown].told) {
            return 0x03;
        }
        if (has[high_warning].told) {
            return 0x02;
        }
        return has[low_warning].told ? 0x04 : 0x00;
    }

    std::array<std::array<Fault, 4>, 2> faults{};
    std::array<Fault, 3> unit_faults{};

  private:
    static constexpr std::int16_t disabled_value = -1;
    static constexpr std::int16_t open_value = -512;

    static std::int16_t scaled(float celsius, float factor, float offset) {
        const double value = static_cast<double>(celsius) * static_cast<double>(factor) + static_cast<double>(offset);
        return static_cast<std::int16_t>(std::min(std::max(std::round(value), -32768.0), 32767.0));
    }
    /// Returns a measured value; it avoids -1 and -512, which are reserved.
    static std::int16_t measured(float celsius, float factor, float offset) {
        const std::int16_t value = scaled(celsius, factor, offset);
        return static_cast<std::int16_t>(value == disabled_value || value == open_value ? value + 1 : value);
    }

    void evaluate_channel(std::size_t i, const Channel& set, std::uint64_t now) {
        const Converter& converter = converters_[i];
        Shown next;
        next.uv = shown_[i].uv;
        if (!converter.open()) {
            next.uv = converter.uv() + (set.compensated ? uv_of(set.type, static_cast<double>(cold_junction_c_)) : 0.0);
        }
        if (!set.enabled) {
            faults[i] = {};
            next.process = disabled_value;
        } else if (converter.open()) {
            faults[i][open_circuit].judge(true, false, set.delay_ms, now);
            for (const ChannelFault one : {high_warning, low_warning, shutdown}) {
                faults[i][one].since.reset();
            }
            next.process = open_value;
        } else {
            faults[i][open_circuit].judge(false, true, set.delay_ms, now);
            next.valid = true;
            next.celsius = told_celsius(i, celsius_of(set.type, next.uv));
            next.process = measured(next.celsius, set.factor, set.offset);
            judge_limits(i, set, next, now);
        }
        shown_[i] = next;
    }
    float told_celsius(std::size_t i, double celsius) const {
        const float observed = observe_(static_cast<unsigned>(i));
        constexpr double last_digits_c = 1e-4;
        return std::fabs(static_cast<double>(observed) - celsius) <= last_digits_c ? observed
                                                                                   : static_cast<float>(celsius);
    }
    void judge_limits(std::size_t i, const Channel& set, const Shown& now_shown, std::uint64_t now) {
        const double tenths = static_cast<double>(now_shown.celsius) * 10.0;
        const bool above = is_above(set.type, now_shown.uv);
        const bool below = is_below(set.type, now_shown.uv);
        constexpr double hysteresis = 10.0;  // 1 degC, in tenths
        faults[i][high_warning].judge(tenths > set.high, tenths <= set.high - hysteresis, set.delay_ms, now);
        faults[i][low_warning].judge(below || tenths < set.low, !below && tenths >= set.low + hysteresis, set.delay_ms,
                                     now);
        faults[i][shutdown].judge(above || tenths > set.shutdown, !above && tenths <= set.shutdown - hysteresis,
                                  set.delay_ms, now);
    }
    void judge_unit(std::size_t i, const Application& all, bool begins, bool ends, std::uint64_t now) {
        const std::size_t quantity = i == 0 ? 0 : 1;
        if (all.fd_enabled[quantity]) {
            unit_faults[i].judge(begins, ends, all.fd_delay_ms[quantity], now);
        } else {
            unit_faults[i] = Fault{};
        }
    }

    Observe observe_;
    std::array<Converter, 2> converters_{};
    std::array<Shown, 2> shown_{};
    bool hum_rises_{true};
    float cold_junction_c_{0.0F};
    float cpu_c_{0.0F};
    float supply_v_{0.0F};
};

}  // namespace canproof::naive_tcs
