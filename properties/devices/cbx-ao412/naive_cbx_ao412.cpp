// SPDX-License-Identifier: Apache-2.0
#include "properties/devices/cbx-ao412/naive_cbx_ao412.hpp"

#include <algorithm>

namespace canproof::naive_ao4 {

namespace {

unsigned word(const std::vector<unsigned>& data, std::size_t at) {
    return data[at] | (data[at + 1] << 8U);
}

/// Moves all frames in `waiting` to `to`, in the order of arbitration, each with the time `now`.
void drain(std::multimap<std::string, std::string>& waiting, std::uint64_t now,
           std::vector<std::pair<std::uint64_t, std::string>>& to) {
    for (const auto& [id, text] : waiting) {
        to.emplace_back(now, text);
    }
    waiting.clear();
}

}  // namespace

std::string Device::text_of(unsigned id, const std::vector<unsigned>& data) {
    std::string text = fmt::format("{:03X}#", id);
    for (const unsigned one : data) {
        text += fmt::format("{:02X}", one & 0xFFU);
    }
    return text;
}

/// Starts the device with the present positions of the switches (sections 3.3, 7.5).
void Device::power_on(const Terminals& at, std::uint64_t now) {
    now_ = now;
    node_ = 16 * at.high + at.low;
    baud_ = at.baud;
    runs_ = node_ >= 1 && node_ <= 127;
    outputs_ = {};
    may_send_at_ = 0;
    shown_internal_ = false;
    failed_ = false;
    communication_failed_ = false;
    state_ = State::initialising;
    at_ = at;
    if (runs_) {
        reset_node();
    }
    watch_internal();
    keep_sent();
}

void Device::set_terminals(const Terminals& at) {
    const unsigned before = std::exchange(at_, at).can;
    if (runs_ && before != at.can) {
        flush();
        if (before >= 3) {
            enlist(bus_off_over);
            announce({bus_off_over, false});
        }
        set(passive, at.can >= 2);
        watch();
    }
    set(overrun, at.overrun);
    watch_internal();
    update_failed();
    keep_sent();
}

void Device::receive(unsigned id, const std::vector<unsigned>& data) {
    if (!runs_ || is_off()) {
        return;
    }
    if (id == 0 && data.size() == 2 && (data[1] == 0 || data[1] == node_)) {
        obey(data[0]);
    } else if (id == 0x080 && state_ != State::stopped) {
        sync(data.size());
    } else if (id == 0x300 + node_ && state_ == State::operational && data.size() == 8) {
        settings_.rpdo_type > 240 ? take_rpdo(data) : void(waiting_rpdo_ = data);
    } else if (id > 0x700 && id <= 0x77F && data.size() == 1) {
        heard(id - 0x700);
    } else if (id == 0x600 + node_ && state_ != State::stopped) {
        write(word(data, 1), data[3], word(data, 4) | (word(data, 6) << 16U));
    }
    watch();
    keep_sent();
}

/// Answers a remote frame (sections 7.9.10, 7.7.2).
void Device::ask(unsigned id) {
    if (!runs_ || is_off()) {
        return;
    }
    if (id == 0x700 + node_ && settings_.heartbeat_ms == 0) {
        constexpr std::array<unsigned, 4> octets{0, 127, 5, 4};
        sent_.push_back(text_of(id, {octets[static_cast<std::size_t>(state_)] + (toggle_ ? 128U : 0U)}));
        toggle_ = !toggle_;
        guarding_failed_ = false;
        guarded_until_.reset();
        if (settings_.guard_ms * settings_.life_factor != 0) {
            guarded_until_ = now_ + settings_.guard_ms * settings_.life_factor;
        }
    } else if (id == 0x300 + node_ && state_ == State::operational) {
        std::vector<unsigned> data;
        for (const OutputSettings& one : settings_.outputs) {
            data.push_back(static_cast<unsigned>(one.command));
            data.push_back(static_cast<unsigned>(one.command) >> 8U);
        }
        sent_.push_back(text_of(id, data));
    }
    watch();
    keep_sent();
}

void Device::pass(std::uint64_t ms) {
    for (; ms > 0; --ms) {
        ++now_;
        if (runs_) {
            tick();
            keep_sent();
        }
    }
}

void Device::tick() {
    if (start_at_ && now_ >= *start_at_) {
        start_at_.reset();
        enter(State::operational);
    }
    if (next_heartbeat_ && now_ >= *next_heartbeat_) {
        constexpr std::array<unsigned, 4> octets{0, 127, 5, 4};
        sent_.push_back(text_of(0x700 + node_, {octets[static_cast<std::size_t>(state_)]}));
        next_heartbeat_ = now_ + settings_.heartbeat_ms;
    }
    if (guarded_until_ && now_ >= *guarded_until_) {
        guarded_until_.reset();
        guarding_failed_ = true;
    }
    if (producer_due_ && now_ >= *producer_due_) {
        producer_due_.reset();
        producer_silent_ = true;
    }
    flush();
    watch();
}

void Device::heard(unsigned producer) {
    if (producer == settings_.consumer_node && settings_.consumer_ms != 0) {
        producer_silent_ = false;
        producer_due_ = now_ + settings_.consumer_ms;
    }
}

void Device::obey(unsigned specifier) {
    switch (specifier) {
        case 0x01:
            start_at_.reset();
            return enter(State::operational);
        case 0x02:
            start_at_.reset();
            return enter(State::stopped);
        case 0x80:
            start_at_.reset();
            return enter(State::pre_operational);
        case 0x81:
            return reset_node();
        case 0x82:
            take_communication(settings_, stored_);
            list_.clear();
            may_send_at_ = 0;
            return boot();
        default:
            return;
    }
}

void Device::reset_node() {
    state_ = State::initialising;
    settings_ = stored_;
    active_.fill(false);
    waiting_.clear();
    list_.clear();
    may_send_at_ = 0;
    communication_failed_ = is_off();
    failing_ = {};
    failed_ = false;
    shown_internal_ = false;
    for (std::size_t i = 0; i < 4 && !is_internal() && !is_off(); ++i) {
        outputs_[i].command(settings_.outputs[i].command);
    }
    update_failed();
    set(overrun, at_.overrun);
    boot();
}

void Device::boot() {
    state_ = State::initialising;
    start_at_.reset();
    toggle_ = false;
    guarding_failed_ = false;
    producer_silent_ = false;
    producer_due_.reset();
    guarded_until_.reset();
    waiting_rpdo_.reset();
    next_heartbeat_.reset();
    if (settings_.heartbeat_ms != 0) {
        next_heartbeat_ = now_ + settings_.heartbeat_ms;
    }
    set(passive, at_.can >= 2);
    sent_.push_back(text_of(0x700 + node_, {0}));
    enter(State::pre_operational);
    watch();
    watch_internal();
    if (settings_.start == 8 && !(communication_failed_ && settings_.behaviour != 1)) {
        start_at_ = now_ + settings_.start_ms;
    }
}

void Device::enter(State state) {
    state_ = state;
    if (state != State::operational) {
        waiting_rpdo_.reset();
    }
    flush();
}

void Device::sync(std::size_t length) {
    set(sync_length, length != 0);
    if (length == 0 && waiting_rpdo_) {
        take_rpdo(*waiting_rpdo_);
        waiting_rpdo_.reset();
    }
}

void Device::take_rpdo(const std::vector<unsigned>& data) {
    for (std::size_t i = 0; i < 4; ++i) {
        change_output(0x6411, settings_.outputs[i], outputs_[i], word(data, 2 * i));
    }
}

/// Checks heartbeat, guarding and bus-off (section 7.9.21). When one of them fails, 1029h (error behaviour) determines
/// the new NMT state, and 6443h (Analogue Output Error Mode) the outputs.
void Device::watch() {
    const bool silent = producer_silent_ || guarding_failed_;
    set(guard, silent);
    communication_failed_ = silent || is_off();
    const auto before = std::exchange(failing_, {producer_silent_, guarding_failed_, is_off()});
    bool begins = false;
    for (std::size_t i = 0; i < failing_.size(); ++i) {
        begins = begins || (failing_[i] && !before[i]);
    }
    if (begins && settings_.behaviour != 1) {
        start_at_.reset();
        if (settings_.behaviour == 2) {
            enter(State::stopped);
        } else if (state_ == State::operational) {
            enter(State::pre_operational);
        }
    }
    update_failed();
}

void Device::watch_internal() {
    shown_internal_ = shown_internal_ || is_internal();
    set(software, at_.software);
    set(hardware, at_.hardware);
}

void Device::update_failed() {
    const bool fails = runs_ && (communication_failed_ || is_internal());
    if (fails && !failed_) {
        for (std::size_t i = 0; i < 4; ++i) {
            outputs_[i].fail(settings_.outputs[i]);
        }
    }
    failed_ = fails;
}

Light Device::can_light() const {
    if (!runs_ || is_off()) {
        return Light::on;
    }
    if (active_[guard]) {
        return Light::two_flashes;
    }
    return at_.can == 0 ? Light::off : Light::one_flash;
}

Light Device::status_light() const {
    if (!runs_) {
        return Light::three_flashes;
    }
    if (state_ == State::operational) {
        return Light::on;
    }
    return state_ == State::stopped ? Light::one_flash : Light::blinking;
}

Light Device::error_light() const {
    if (shown_internal_) {
        return Light::two_flashes;
    }
    return at_.overrun ? Light::on : Light::off;
}

void Device::set(Error error, bool present) {
    if (!runs_ || active_[error] == present) {
        return;
    }
    active_[error] = present;
    if (present) {
        enlist(error);
    }
    announce({error, !present});
}

void Device::enlist(Error error) {
    list_.push_front(codes[error]);
    list_.resize(std::min<std::size_t>(list_.size(), 10));
}

/// Queues a message. At most two messages of each error wait: one for the first state of the error and one for its
/// present state (decision AO4-D-073).
void Device::announce(const Waiting& told) {
    const auto same = [&](const Waiting& one) { return one.error == told.error; };
    const auto last = std::find_if(waiting_.rbegin(), waiting_.rend(), same);
    if (last == waiting_.rend() || last->cured != told.cured) {
        if (std::count_if(waiting_.begin(), waiting_.end(), same) == 2) {
            waiting_.erase(std::next(last).base());
        } else {
            waiting_.push_back(told);
        }
    }
    flush();
}

void Device::flush() {
    while (talks() && !waiting_.empty() && may_send_at_ <= now_) {
        const Waiting told = waiting_.front();
        waiting_.pop_front();
        const unsigned code = told.cured ? 0 : codes[told.error];
        sent_.push_back(text_of(0x080 + node_,
                                {code, code >> 8U, error_register(), static_cast<unsigned>(list_.size()), 0, 0, 0, 0}));
        may_send_at_ = now_ + settings_.inhibit_ms;
    }
}

/// Moves the frames of this moment to the list of sent frames. No frame comes before a boot-up message that waits. In
/// bus-off no frame is sent.
void Device::keep_sent() {
    if (sent_.empty() && !is_off()) {
        return;
    }
    std::multimap<std::string, std::string> waiting;
    const std::string boot_up = text_of(0x700 + node_, {0});
    for (const auto& text : sent_) {
        if (text == boot_up) {
            waiting.clear();
            kept_.emplace_back(now_, text);
        } else {
            waiting.emplace(text.substr(0, 3), text);
        }
    }
    if (is_off()) {
        kept_.clear();
    } else {
        drain(waiting, now_, kept_);
    }
    sent_.clear();
}

}  // namespace canproof::naive_ao4
