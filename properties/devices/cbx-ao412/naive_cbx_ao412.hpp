// SPDX-License-Identifier: Apache-2.0
// Naive model of the whole CAN-CBX-AO412, written from the sentences of the manual, with a clock in milliseconds. It
// covers outputs, errors and emergency messages, states, self-start, heartbeat and guarding, LEDs, switches and
// storing. Shares no code with the firmware.
#pragma once

#include <fmt/format.h>

#include <array>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "properties/devices/cbx-ao412/naive_leds.hpp"
#include "properties/devices/cbx-ao412/naive_outputs.hpp"

namespace canproof::naive_ao4 {

enum class State { initialising, pre_operational, operational, stopped };

struct Terminals {
    unsigned high{0};
    unsigned low{3};
    unsigned baud{6};
    unsigned can{0};  ///< 0 active, 1 warning, 2 passive, 3 bus-off
    bool overrun{false};
    bool software{false};
    bool hardware{false};
};

/// The errors of section 7.9.4, in the order in which they are reported.
enum Error : std::size_t { overrun, passive, guard, sync_length, software, hardware, bus_off_over, error_count };
constexpr std::array<unsigned, error_count> codes{0x8110, 0x8120, 0x8130, 0x8240, 0x6110, 0x5000, 0x8140};
constexpr std::array<unsigned, error_count> bits{0x11, 0x11, 0x11, 0x11, 0x01, 0x01, 0x00};

/// The parameters that 1010h (store parameters) stores.
struct Settings {
    std::array<OutputSettings, 4> outputs{};
    unsigned consumer_node{0};
    unsigned consumer_ms{0};
    unsigned heartbeat_ms{0};
    unsigned guard_ms{0};
    unsigned life_factor{0};
    unsigned inhibit_ms{0};
    unsigned behaviour{0};
    unsigned rpdo_type{255};
    unsigned start{2};
    unsigned start_ms{100};
};

/// Copies the parameters of 1000h to 1FFFh from `from` to `to`; those of the outputs stay unchanged.
inline void take_communication(Settings& to, const Settings& from) {
    const auto outputs = to.outputs;
    to = from;
    to.outputs = outputs;
}

class Device {
  public:
    using Sent = std::vector<std::pair<std::uint64_t, std::string>>;

    /// Makes a device with `offset` and `gain` as the factory calibration of its outputs.
    Device(const std::array<int, 4>& offset, const std::array<int, 4>& gain) {
        for (std::size_t i = 0; i < 4; ++i) {
            shipped_.outputs[i].offset = offset[i];
            shipped_.outputs[i].gain = gain[i];
        }
        stored_ = shipped_;
    }

    void power_on(const Terminals& at, std::uint64_t now);
    void set_terminals(const Terminals& at);
    /// Receives a data frame.
    void receive(unsigned id, const std::vector<unsigned>& data);
    /// Receives a remote frame.
    void ask(unsigned id);
    void pass(std::uint64_t ms);

    Sent take_sent() { return std::exchange(kept_, {}); }
    std::uint64_t now() const { return now_; }
    bool runs() const { return runs_; }
    unsigned node() const { return node_; }
    State state() const { return state_; }
    const Settings& settings() const { return settings_; }
    Steps output(std::size_t i) const { return outputs_[i].shown(settings_.outputs[i]); }
    unsigned error_register() const {
        unsigned all = 0;
        for (std::size_t i = 0; i < error_count; ++i) {
            all |= active_[i] ? bits[i] : 0U;
        }
        return all;
    }
    const std::deque<unsigned>& list() const { return list_; }
    std::uint32_t rate() const { return bit_rate(baud_); }
    /// Returns the states of the LEDs E, S, M and P (section 3.2).
    std::array<bool, 4> leds() const {
        return {is_lit(can_light(), true, now_), is_lit(status_light(), false, now_), is_lit(error_light(), true, now_),
                is_lit(runs_ ? Light::on : Light::off, false, now_)};
    }

  private:
    struct Waiting {
        Error error;
        bool cured;
    };
    static std::string text_of(unsigned id, const std::vector<unsigned>& data);
    Light can_light() const;
    Light status_light() const;
    Light error_light() const;

    void tick();
    void heard(unsigned producer);
    void obey(unsigned specifier);
    void reset_node();
    void boot();
    void enter(State state);
    void write(unsigned index, unsigned sub, std::uint32_t value);
    std::uint32_t change(unsigned index, unsigned sub, std::uint32_t value);
    std::uint32_t change_output(unsigned index, OutputSettings& set, Output& output, std::uint32_t value);
    std::uint32_t change_supervision(unsigned index, unsigned sub, std::uint32_t value);
    void take_rpdo(const std::vector<unsigned>& data);
    void sync(std::size_t length);
    void watch();
    void watch_internal();
    void update_failed();

    bool is_internal() const { return at_.software || at_.hardware; }
    bool is_off() const { return at_.can >= 3; }
    bool talks() const { return runs_ && !is_off() && state_ != State::stopped && state_ != State::initialising; }
    void set(Error error, bool present);
    void enlist(Error error);
    void announce(const Waiting& told);
    void flush();
    void keep_sent();

    Settings shipped_{};
    Settings stored_{};
    Settings settings_{};
    Terminals at_{};
    std::uint64_t now_{0};
    bool runs_{false};
    unsigned node_{0};
    unsigned baud_{0};
    State state_{State::initialising};
    std::array<Output, 4> outputs_{};
    std::array<bool, error_count> active_{};
    std::deque<unsigned> list_;
    std::deque<Waiting> waiting_;
    std::uint64_t may_send_at_{0};
    bool communication_failed_{false};
    std::array<bool, 3> failing_{};  ///< present failures: lost heartbeat, lost guarding, bus-off
    bool failed_{false};
    bool shown_internal_{false};
    bool toggle_{false};
    bool guarding_failed_{false};
    bool producer_silent_{false};
    std::optional<std::uint64_t> producer_due_;
    std::optional<std::uint64_t> guarded_until_;
    std::optional<std::uint64_t> next_heartbeat_;
    std::optional<std::uint64_t> start_at_;
    std::optional<std::vector<unsigned>> waiting_rpdo_;
    std::vector<std::string> sent_;
    Sent kept_;
};

}  // namespace canproof::naive_ao4
