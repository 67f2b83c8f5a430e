// SPDX-License-Identifier: Apache-2.0
// Naive model of the errors of the conformance slave (node 5) by CiA 301 (7.2.7, 7.5.2.2, 7.5.2.4, 7.5.2.16, 7.5.2.17).
// It has the error register, the list of the last four errors, and emergency messages with their inhibit time, with a
// clock in milliseconds. Shares no code with the firmware.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

namespace canproof::naive_emcy {

using Message = std::array<std::uint8_t, 8>;
using Sent = std::vector<std::pair<std::uint64_t, Message>>;

enum class Error { overrun, passive, sync_length, rpdo_length, internal, bus_off_recovered };
enum class Can { active, warning, passive, off };
enum class State { pre_operational, operational, stopped };

class Node {
  public:
    /// Receives an NMT command to this node or all nodes.
    void command(unsigned specifier) {
        if (can_ == Can::off) {
            return;
        }
        switch (specifier) {
            case 0x01:
                return enter(State::operational);
            case 0x02:
                return enter(State::stopped);
            case 0x80:
                return enter(State::pre_operational);
            case 0x81:
                return reset_node();
            case 0x82:
                return reset_communication();
            default:
                return;
        }
    }
    void can_state(Can state) {
        if (state == can_) {
            return;
        }
        const bool returns = can_ == Can::off;
        can_ = state;
        if (can_ == Can::off) {
            take_back();
        }
        flush();
        if (returns) {
            report(Error::bus_off_recovered);
        }
        set(Error::passive, state >= Can::passive);
        if (state == Can::off && state_ == State::operational) {
            enter(State::pre_operational);  // 1029h:1 (error behaviour at a communication error) is 0
        }
    }
    /// Begins or ends a time in which the bus carries nothing, so that messages wait in the transmit queue.
    void block(bool blocked) {
        blocked_ = blocked;
        events_blocked_ = 0;
        deliver();
    }
    void overrun(bool lost) {
        lost_ = lost;
        set(Error::overrun, lost);
    }
    void internal_fault(bool present) { set(Error::internal, present); }
    /// Receives a SYNC. Without a SYNC counter, a SYNC of the right length has no data.
    void sync(unsigned length) {
        if (hears() && state_ != State::stopped) {
            set(Error::sync_length, length != 0);
        }
    }
    /// Receives RPDO1 with `length` bytes; it maps two bytes.
    void rpdo(unsigned length) {
        if (hears() && state_ == State::operational) {
            set(Error::rpdo_length, length < 2);
        }
    }
    void write_list_length(unsigned value) {
        if (has_sdo() && value == 0) {
            list_.clear();
        }
    }
    /// Writes bit 31 of 1014h (COB-ID EMCY). If this bit disables EMCY, messages that wait are dropped.
    void write_valid(bool valid) {
        if (has_sdo()) {
            valid_ = valid;
            if (!valid) {
                waiting_.clear();
            }
        }
    }
    void write_inhibit(unsigned ms) {
        if (has_sdo()) {
            inhibit_ms_ = ms;
        }
    }
    void pass(std::uint64_t ms) {
        for (; ms > 0; --ms) {
            ++now_;
            flush();
        }
    }

    unsigned error_register() const {
        unsigned bits = 0;
        for (unsigned i = 0; i < active_.size(); ++i) {
            bits |= active_[i] ? bits_of(static_cast<Error>(i)) : 0U;
        }
        return bits;
    }
    /// Returns the error codes in 1003h (error list), the latest first.
    const std::deque<unsigned>& list() const { return list_; }
    State state() const { return state_; }
    bool is_blocked() const { return blocked_; }
    void count_event() { events_blocked_ += blocked_ ? 1U : 0U; }
    /// Returns whether more events could fill the transmit queue, which has room for 32 frames.
    bool is_blocked_for_long() const { return events_blocked_ >= 4U; }
    Sent take_sent() { return std::exchange(sent_, {}); }

  private:
    /// A waiting emergency message. Other content, such as the error register, is added when the message is sent.
    struct Waiting {
        Error error;
        bool cured;
    };
    /// A message in the transmit queue.
    struct Queued {
        Waiting told;
        Message message;
    };
    static constexpr std::size_t list_capacity = 4;

    // The error codes are those of CiA 301, 7.2.7.1, Table 26. In 1001h (error register), bit 0 is the generic error
    // and bit 4 the communication error.
    static unsigned code_of(Error error) {
        constexpr std::array<unsigned, 6> codes{0x8110, 0x8120, 0x8240, 0x8210, 0x6100, 0x8140};
        return codes[static_cast<std::size_t>(error)];
    }
    static unsigned bits_of(Error error) { return error == Error::internal ? 0x01U : 0x11U; }

    bool hears() const { return can_ != Can::off; }
    bool has_sdo() const { return hears() && state_ != State::stopped; }
    bool talks() const { return can_ != Can::off && state_ != State::stopped; }

    void enter(State state) {
        state_ = state;
        flush();
    }
    void reset_node() {
        active_.fill(false);
        waiting_.clear();
        queued_.clear();
        list_.clear();
        may_send_at_ = 0;
        state_ = State::stopped;  // the node sends no message before its boot-up message
        restore_defaults();
        set(Error::overrun, lost_);
        set(Error::passive, can_ >= Can::passive);
        enter(State::pre_operational);
    }
    void reset_communication() {
        list_.clear();
        may_send_at_ = 0;
        restore_defaults();
        take_back();
        enter(State::pre_operational);
        set(Error::rpdo_length, false);
    }
    void restore_defaults() {
        valid_ = true;
        inhibit_ms_ = 0;
    }

    void set(Error error, bool present) {
        bool& is = active_[static_cast<std::size_t>(error)];
        if (is == present) {
            return;
        }
        is = present;
        if (present) {
            enlist(error);
        }
        announce({error, !present});
    }
    /// Reports an error that has already ended, such as bus-off after the recovery.
    void report(Error error) {
        enlist(error);
        announce({error, false});
    }
    void enlist(Error error) {
        list_.push_front(code_of(error));
        if (list_.size() > list_capacity) {
            list_.pop_back();
        }
    }
    /// Queues a message. At most two messages of each error wait: one for the first state of the error and one for its
    /// present state. If the error returns to its first state, the newer message is dropped, and the older one shows
    /// the present state.
    void announce(const Waiting& told) {
        if (!valid_) {
            return;
        }
        std::vector<std::size_t> same;
        for (std::size_t i = 0; i < waiting_.size(); ++i) {
            if (waiting_[i].error == told.error) {
                same.push_back(i);
            }
        }
        if (!same.empty() && waiting_[same.back()].cured == told.cured) {
            return;  // the same message waits already
        }
        if (same.size() == 2) {
            waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(same.back()));
        } else {
            waiting_.push_back(told);
        }
        flush();
    }
    void flush() {
        while (talks() && !waiting_.empty() && may_send_at_ <= now_) {
            const Waiting told = waiting_.front();
            waiting_.pop_front();
            const unsigned code = told.cured ? 0U : code_of(told.error);
            queued_.push_back({told,
                               {static_cast<std::uint8_t>(code), static_cast<std::uint8_t>(code >> 8U),
                                static_cast<std::uint8_t>(error_register()), static_cast<std::uint8_t>(list_.size())}});
            may_send_at_ = now_ + inhibit_ms_;
        }
        deliver();
    }
    void deliver() {
        for (; !blocked_ && !queued_.empty(); queued_.pop_front()) {
            sent_.emplace_back(now_, queued_.front().message);
        }
    }
    /// Empties the transmit queue. Its messages wait again, before the others, unless messages are disabled. Again at
    /// most two messages of each error wait.
    void take_back() {
        for (; valid_ && !queued_.empty(); queued_.pop_back()) {
            const Waiting& told = queued_.back().told;
            const auto is_same = [&told](const Waiting& one) { return one.error == told.error; };
            const auto count = std::count_if(waiting_.begin(), waiting_.end(), is_same);
            const auto oldest = std::find_if(waiting_.begin(), waiting_.end(), is_same);
            if (count == 0 || (count == 1 && oldest->cured != told.cured)) {
                waiting_.push_front(told);
            } else if (oldest->cured != told.cured) {
                waiting_.erase(oldest);
            }
        }
        queued_.clear();
    }

    std::uint64_t now_{0};
    State state_{State::pre_operational};
    Can can_{Can::active};
    bool lost_{false};
    bool valid_{true};
    unsigned inhibit_ms_{0};
    std::uint64_t may_send_at_{0};
    std::array<bool, 6> active_{};
    std::deque<Waiting> waiting_;
    std::deque<Queued> queued_;
    bool blocked_{false};
    unsigned events_blocked_{0};
    std::deque<unsigned> list_;
    Sent sent_;
};

/// One event of an exchange. A generator or a fuzzer may choose any numbers for it.
struct Event {
    unsigned kind{0};  ///< see apply()
    unsigned a{0};     ///< up to FFh
};
constexpr unsigned event_kinds = 10;
/// The kind of an event that begins or ends a time in which the bus carries nothing. Only the property has such events.
constexpr unsigned block_kind = 10;

inline unsigned command_of(const Event& event) {
    constexpr std::array<unsigned, 8> commands{0x01, 0x02, 0x80, 0x81, 0x82, 0x01, 0x80, 0x02};
    return commands[event.a % commands.size()];
}

/// The frame that an event sends to the node. Events that concern the CAN controller, the device or the time have no
/// frame.
struct EventFrame {
    bool is_one{false};
    unsigned id{0};
    std::vector<std::uint8_t> data;
};

inline EventFrame frame_of(const Event& event) {
    switch (event.kind) {
        case 0:
            return {true,
                    0,
                    {static_cast<std::uint8_t>(command_of(event)), static_cast<std::uint8_t>(event.a / 8U % 2U * 5U)}};
        case 1:
            return {true, 0x080, std::vector<std::uint8_t>(event.a % 3U)};
        case 2:
            return {true, 0x205, std::vector<std::uint8_t>(event.a % 4U)};
        case 3:
            return {true, 0x605, {0x2F, 0x03, 0x10, 0x00, static_cast<std::uint8_t>(event.a % 3U), 0, 0, 0}};
        case 4:
            return {true, 0x605, {0x23, 0x14, 0x10, 0x00, 0x85, 0, 0, static_cast<std::uint8_t>(event.a % 2U * 0x80U)}};
        case 5: {
            const unsigned hundreds = event.a % 40U * 10U;
            return {true,
                    0x605,
                    {0x2B, 0x15, 0x10, 0x00, static_cast<std::uint8_t>(hundreds),
                     static_cast<std::uint8_t>(hundreds >> 8U), 0, 0}};
        }
        default:
            return {};
    }
}

inline void apply(Node& node, const Event& event) {
    node.count_event();
    switch (event.kind) {
        case 0:
            return node.command(command_of(event));
        case 1:
            return node.sync(event.a % 3U);
        case 2:
            return node.rpdo(event.a % 4U);
        case 3:
            return node.write_list_length(event.a % 3U);
        case 4:
            return node.write_valid(event.a % 2U == 0);
        case 5:
            return node.write_inhibit(event.a % 40U);
        case 6:
            return node.can_state(static_cast<Can>(event.a % 4U));
        case 7:
            return node.overrun(event.a % 2U != 0);
        case 8:
            return node.internal_fault(event.a % 2U != 0);
        case block_kind:
            return node.block(event.a % 2U != 0);
        default:
            return node.pass(event.a);
    }
}

}  // namespace canproof::naive_emcy
