// SPDX-License-Identifier: Apache-2.0
// Naive model of the whole AX188001 at node-ID 127, written from the sentences of the manual, with a clock in
// milliseconds. It has measurement, faults, emergency messages, states, self-start, TPDOs and storing. Guarding,
// heartbeats and inhibit times have separate models. Shares no code with the firmware.
#pragma once

#include <map>

#include "properties/devices/ax188001/naive_messages.hpp"
#include "properties/devices/ax188001/naive_scanner.hpp"

namespace canproof::naive_tcs {

enum class State { pre_operational, operational, stopped };

class Ax188001 {
  public:
    using Sent = std::vector<std::pair<std::uint64_t, std::string>>;

    explicit Ax188001(Scanner::Observe observe) : scanner_{std::move(observe)} {}
    Ax188001(const Ax188001&) = delete;
    Ax188001& operator=(const Ax188001&) = delete;

    void power_on(const Terminals& at, std::uint64_t now) {
        now_ = now;
        at_ = at;
        reset_node();
        start_when_allowed();
        keep_sent();
    }
    void set_terminals(const Terminals& at) {
        const bool was_off = is_off();
        at_ = at;
        messages_.allow(may_tell());
        if (was_off && !is_off()) {
            messages_.tell_bus_off_over();
        }
        watch();
        messages_.set(overrun_error, at.overrun);
        keep_sent();
    }
    /// Receives an NMT command; `node` 0 addresses all nodes.
    void command(unsigned specifier, unsigned node) {
        if (one_of(specifier, {0x01, 0x02, 0x80, 0x81, 0x82}) != 0) {
            return;
        }
        others_at_.reset();  // a command shows that a master is present
        if (!is_off() && (node == 0 || node == 127)) {
            obey(specifier);
        }
        keep_sent();
    }
    /// Performs a download of up to four bytes.
    void write(unsigned index, unsigned sub, std::uint32_t bits) {
        if (state_ == State::stopped || is_off()) {
            return;
        }
        const std::uint32_t refused = change(index, sub, bits);
        if (refused == 0) {
            sent_.push_back(fmt::format("5FF#60{:02X}{:02X}{:02X}00000000", index & 0xFFU, index >> 8U, sub));
        } else {
            sent_.push_back(
                fmt::format("5FF#80{:02X}{:02X}{:02X}{}", index & 0xFFU, index >> 8U, sub, bytes(refused, 4)));
        }
        keep_sent();
    }
    void pass(std::uint64_t ms) {
        for (; ms > 0; --ms) {
            ++now_;
            tick();
            keep_sent();
        }
    }

    Sent take_sent() { return std::exchange(kept_, {}); }
    std::uint64_t now() const { return now_; }
    State state() const { return state_; }
    const Scanner& scanner() const { return scanner_; }
    const Messages& messages() const { return messages_; }
    const Application& application() const { return application_; }

    /// Returns the value of a mappable object as a bit pattern (sections 3.3, 3.4).
    std::uint32_t value(unsigned index, unsigned sub) const {
        const Shown average = scanner_.average(application_);
        switch (index) {
            case 0x6100:
                return field_bits(scanner_.shown(sub - 1));
            case 0x7130:
                return word(scanner_.shown(sub - 1).process);
            case 0x6150:
                return scanner_.status(sub - 1);
            case 0x2100:
                return field_bits(average);
            case 0x2130:
                return word(average.process);
            case 0x3100:
                return real_bits(scanner_.cold_junction_c());
            case 0x3130:
                return word(scanner_.cold_junction_process(application_));
            default:
                return real_bits(static_cast<float>(scanner_.fd_value(sub - 1)));
        }
    }

  private:
    static constexpr std::uint64_t reading_ms = 165;

    static std::uint32_t real_bits(float value) {
        std::uint32_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        return bits;
    }
    static std::uint32_t field_bits(const Shown& shown) { return shown.valid ? real_bits(shown.celsius) : 0xFFC00000; }
    static std::uint32_t word(std::int16_t value) { return static_cast<std::uint16_t>(value); }
    static std::string bytes(std::uint32_t value, unsigned count) {
        std::string text;
        for (unsigned i = 0; i < count; ++i) {
            text += fmt::format("{:02X}", (value >> (8U * i)) & 0xFFU);
        }
        return text;
    }

    void tick() {
        if (now_ >= next_reading_) {
            scanner_.read(application_, at_);
            scanner_.evaluate(application_, now_);
            next_reading_ += reading_ms;
        }
        scanner_.expire(application_, now_);
        tell_faults();
        for (std::size_t i = 0; i < 4; ++i) {
            if (next_tpdo_[i] && now_ >= *next_tpdo_[i]) {
                send_tpdo(i);
            }
        }
        start_others();
    }
    void start_others() {
        if (others_at_ && now_ >= *others_at_) {
            others_at_.reset();
            if (state_ == State::operational) {
                sent_.push_back("000#0100");
            }
        }
    }
    /// Reports faults; 1029h (error behaviour) then determines the state of the node (section 3.2.13).
    void tell_faults() {
        for (std::size_t i = 0; i < 8; ++i) {
            tell(first_channel_error + i, scanner_.faults[i / 4][i % 4].told, 2);
        }
        for (std::size_t i = 0; i < 3; ++i) {
            tell(first_unit_error + i, scanner_.unit_faults[i].told, 3);
        }
    }
    void tell(std::size_t error, bool present, std::size_t reaction) {
        const bool begins = present && !messages_.is_active(error);
        messages_.set(error, present);
        if (begins) {
            react(communication_.reaction[reaction]);
        }
    }
    void react(unsigned wanted) {
        if (wanted != 1) {
            starts_ = false;
        }
        if (wanted == 2) {
            enter(State::stopped);
        } else if (wanted == 0 && state_ == State::operational) {
            enter(State::pre_operational);
        }
    }

    void enter(State next) {
        const State before = std::exchange(state_, next);
        for (std::size_t i = 0; i < 4; ++i) {
            if (next != State::operational) {
                next_tpdo_[i].reset();
            } else if (before != State::operational) {
                begin_tpdo(i);
            }
        }
        messages_.allow(may_tell());
    }
    bool is_off() const { return at_.can >= 3; }
    bool may_tell() const { return state_ != State::stopped && !is_off(); }
    /// Reacts to bus-off, which counts as a communication error: 1029h:1 (error behaviour) determines the reaction
    /// (decision TCS-D-030).
    void watch() {
        if (std::exchange(fails_, is_off()) != is_off() && is_off()) {
            react(communication_.reaction[1]);
        }
    }
    void begin_tpdo(std::size_t i) {
        const Tpdo& tpdo = communication_.tpdos[i];
        next_tpdo_[i].reset();
        if (tpdo.valid && !tpdo.mapped.empty() && tpdo.event_ms != 0) {
            send_tpdo(i);
        }
    }
    void send_tpdo(std::size_t i) {
        const Tpdo& tpdo = communication_.tpdos[i];
        std::string text = fmt::format("{:03X}#", 0x180 + 0x100 * i + 127);
        for (const Tpdo::Mapped& one : tpdo.mapped) {
            text += bytes(value(one.index, one.sub), one.bytes);
        }
        sent_.push_back(text);
        next_tpdo_[i] = now_ + tpdo.event_ms;
    }

    void obey(unsigned specifier) {
        starts_ = false;
        switch (specifier) {
            case 0x01:
                return enter(State::operational);
            case 0x02:
                return enter(State::stopped);
            case 0x80:
                return enter(State::pre_operational);
            case 0x81:
                reset_node();
                return start_when_allowed();
            default:
                communication_ = stored_communication_;
                boot();
                return start_when_allowed();
        }
    }
    void reset_node() {
        communication_ = stored_communication_;
        application_ = stored_application_;
        start_mode_ = stored_application_.start;
        messages_.allow(false);
        messages_.forget_all();
        scanner_.restart(application_, at_);
        scanner_.evaluate(application_, now_);
        next_reading_ = now_ + reading_ms;
        messages_.set(overrun_error, at_.overrun);
        fails_ = false;
        boot();
    }
    /// Boots: sends the boot-up message and enters pre-operational. Then enters the state required by the stored value
    /// of 5555h (Start in Operational Mode) and by the active faults (sections 1.4, 3.2.13, 3.4.22).
    void boot() {
        messages_.allow(false);
        state_ = State::stopped;
        sent_.push_back("77F#00");
        enter(State::pre_operational);
        watch();
        starts_ = start_mode_ != 0 && (!fails_ || communication_.reaction[1] == 1);
        others_at_.reset();
        if (start_mode_ == 2) {
            others_at_ = now_ + application_.start_delay_ms;
        }
        tell_faults();
        for (std::size_t i = first_channel_error; i < error_kinds.size(); ++i) {
            if (messages_.is_active(i)) {
                react(communication_.reaction[i < first_unit_error ? 2 : 3]);
            }
        }
    }
    void start_when_allowed() {
        if (std::exchange(starts_, false)) {
            enter(State::operational);
        }
        start_others();
    }

    std::uint32_t change(unsigned index, unsigned sub, std::uint32_t bits) {
        if (index == 0x1003) {
            messages_.empty_list();
            return 0;
        }
        if (index == 0x1010) {
            stored_communication_ = communication_;
            stored_application_ = application_;
            start_mode_ = application_.start;
            return 0;
        }
        if (index == 0x1011) {
            stored_communication_ = Communication{};
            stored_application_ = Application{};
            return 0;
        }
        if (index < 0x2000) {
            return change_communication(index, sub, bits);
        }
        const std::uint32_t refused = write_application(application_, index, sub, bits);
        if (refused == 0 && index == 0x2020) {
            scanner_.restart_filters();
        }
        if (refused == 0 && index != 0x5555 && index != 0x5556) {
            scanner_.evaluate(application_, now_);
            tell_faults();
        }
        return refused;
    }
    std::uint32_t change_communication(unsigned index, unsigned sub, std::uint32_t bits) {
        if (index == 0x1029) {
            return keep(within(bits, 0U, 2U), communication_.reaction[sub], bits);
        }
        const std::size_t i = index & 3U;
        Tpdo& tpdo = communication_.tpdos[i];
        if (index >= 0x1A00) {
            map(tpdo, sub, bits);
            return 0;
        }
        if (sub == 1) {
            const bool was_valid = std::exchange(tpdo.valid, (bits >> 31U) == 0);
            next_tpdo_[i] = tpdo.valid ? next_tpdo_[i] : std::nullopt;
            if (!was_valid && tpdo.valid && state_ == State::operational) {
                begin_tpdo(i);
            }
            return 0;
        }
        if (std::exchange(tpdo.event_ms, bits) != bits && state_ == State::operational && tpdo.valid) {
            next_tpdo_[i].reset();
            if (bits != 0) {
                next_tpdo_[i] = now_ + bits;
            }
        }
        return 0;
    }
    /// Maps objects by the steps of the manual: a new mapping applies only when sub-index 0 is set again.
    void map(Tpdo& tpdo, unsigned sub, std::uint32_t bits) {
        if (sub != 0) {
            entries_[sub - 1] = Tpdo::Mapped{bits >> 16U, (bits >> 8U) & 0xFFU, (bits & 0xFFU) / 8U};
            return;
        }
        tpdo.mapped.assign(entries_.begin(), entries_.begin() + bits);
    }

    /// Moves the frames of this moment to the list of sent frames, in the order of arbitration. No frame comes before a
    /// boot-up message. In bus-off no frame is sent.
    void keep_sent() {
        if (sent_.empty() && !is_off()) {
            return;
        }
        std::multimap<std::string, std::string> waiting;
        for (const auto& text : sent_) {
            if (text == "77F#00") {
                drain(waiting);
                kept_.emplace_back(now_, text);
            } else {
                waiting.emplace(text.substr(0, 3), text);
            }
        }
        drain(waiting);
        if (is_off()) {
            kept_.clear();
        }
        sent_.clear();
    }

    void drain(std::multimap<std::string, std::string>& waiting) {
        for (const auto& [id, text] : waiting) {
            kept_.emplace_back(now_, text);
        }
        waiting.clear();
    }

    std::uint64_t now_{0};
    Terminals at_{};
    Application application_{};
    Application stored_application_{};
    Communication communication_{};
    Communication stored_communication_{};
    std::array<Tpdo::Mapped, 4> entries_{};
    Scanner scanner_;
    std::vector<std::string> sent_{};
    Messages messages_{sent_};
    State state_{State::stopped};
    unsigned start_mode_{0};  ///< the stored value of 5555h
    bool starts_{false};
    bool fails_{false};
    std::uint64_t next_reading_{0};
    std::optional<std::uint64_t> others_at_;
    std::array<std::optional<std::uint64_t>, 4> next_tpdo_{};
    Sent kept_;
};

}  // namespace canproof::naive_tcs
