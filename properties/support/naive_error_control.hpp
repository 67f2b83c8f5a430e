// SPDX-License-Identifier: Apache-2.0
// Naive model of NMT, heartbeat and node guarding of the conformance slave (node 5) by CiA 301 (7.2.8, 7.3.2), with a
// clock that advances millisecond by millisecond. Shares no code with the firmware.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace canproof::naive_error_control {

/// The data bytes of the frames that the node sends on 705h, each with its time in ms.
using Said = std::vector<std::pair<std::uint64_t, unsigned>>;

constexpr unsigned node_id = 5;
constexpr unsigned pre_operational = 127;
constexpr unsigned operational = 5;
constexpr unsigned stopped = 4;

class Node {
  public:
    Node() { boot(); }

    /// Receives an NMT command of exactly two bytes on identifier 0.
    void command(unsigned specifier, unsigned addressed) {
        if (addressed != 0 && addressed != node_id) {
            return;
        }
        switch (specifier) {
            case 0x01:
                state_ = operational;
                break;
            case 0x02:
                state_ = stopped;
                break;
            case 0x80:
                state_ = pre_operational;
                break;
            case 0x81:
            // reset node and reset communication differ only in application parameters, which this model does not have
            case 0x82:
                boot();
                break;
            default:
                break;
        }
    }
    /// The functions write_…() below perform an SDO download. They return false if the node refuses the download or
    /// does not answer.
    bool write_heartbeat_time(unsigned ms) {
        if (!has_sdo()) {
            return false;
        }
        heartbeat_ms_ = ms;
        heartbeat_from_ = now_;
        if (ms != 0) {  // a node uses heartbeat or guarding, never both
            guarded_until_ = 0;
            guarding_failed_ = false;
        }
        return settle();
    }
    bool write_guard_time(unsigned ms) { return has_sdo() && write_life_time(ms, life_factor_); }
    bool write_life_factor(unsigned factor) { return has_sdo() && write_life_time(guard_ms_, factor); }
    /// Writes sub-index slot + 1 of 1016h (consumer heartbeat time). The node refuses a producer that another entry
    /// already monitors.
    bool write_consumer(unsigned slot, unsigned node, unsigned ms) {
        if (!has_sdo()) {
            return false;
        }
        const Consumer wanted{node, ms, 0, false};
        for (unsigned i = 0; i < consumers_.size(); ++i) {
            if (i != slot && wanted.is_active() && consumers_[i].is_active() && consumers_[i].node == node) {
                return false;
            }
        }
        consumers_[slot] = wanted;
        return settle();
    }
    bool write_error_behaviour(unsigned wanted) {
        if (!has_sdo() || wanted > 2) {
            return false;
        }
        error_behaviour_ = wanted;
        return true;
    }
    /// Receives a guarding request: a remote frame on 705h.
    void guard() {
        if (heartbeat_ms_ != 0) {
            return;
        }
        say(state_ + (toggle_ ? 0x80U : 0U));
        toggle_ = !toggle_;
        guarding_failed_ = false;
        guarded_until_ = life_ms() == 0 ? 0 : now_ + life_ms();
        settle();
    }
    /// Receives a heartbeat of node `node`: a frame of one byte with the identifier 700h + node.
    void heartbeat_of(unsigned node) {
        for (Consumer& one : consumers_) {
            if (one.is_active() && one.node == node) {
                one.due = now_ + one.ms;
                one.failed = false;
            }
        }
        settle();
    }
    void pass(std::uint64_t ms) {
        for (; ms > 0; --ms) {
            ++now_;
            tick();
        }
    }

    unsigned state() const { return state_; }
    bool has_failed() const { return failing_ != Failing{}; }
    Said take_said() { return std::exchange(said_, {}); }

  private:
    /// Flags that say which monitored nodes are missing: first the guarding master, then the four producers of 1016h
    /// (consumer heartbeat time).
    using Failing = std::array<bool, 5>;
    struct Consumer {
        unsigned node{0};
        unsigned ms{0};
        std::uint64_t due{0};  ///< time in ms at which the producer is missing; 0: no heartbeat was received yet, or it
                               ///< is missing already
        bool failed{false};

        bool is_active() const { return ms != 0 && node >= 1 && node <= 127; }
    };

    bool has_sdo() const { return state_ != stopped; }
    std::uint64_t life_ms() const { return std::uint64_t{guard_ms_} * life_factor_; }
    void say(unsigned octet) { said_.emplace_back(now_, octet); }

    void boot() {
        state_ = pre_operational;
        heartbeat_ms_ = guard_ms_ = life_factor_ = error_behaviour_ = 0;
        guarded_until_ = 0;
        guarding_failed_ = toggle_ = false;
        failing_ = {};
        consumers_.fill(Consumer{});
        say(0);
    }
    /// Sets the life time. If life guarding runs, it continues with the new time; otherwise it starts with the next
    /// guarding request. A life time of 0 ends the life guarding error.
    bool write_life_time(unsigned guard_ms, unsigned factor) {
        guard_ms_ = guard_ms;
        life_factor_ = factor;
        if (guarded_until_ != 0) {
            guarded_until_ = life_ms() == 0 ? 0 : now_ + life_ms();
        }
        guarding_failed_ = guarding_failed_ && life_ms() != 0;
        return settle();
    }
    void tick() {
        if (heartbeat_ms_ != 0 && (now_ - heartbeat_from_) % heartbeat_ms_ == 0) {
            say(state_);
        }
        if (guarded_until_ != 0 && now_ >= guarded_until_) {
            guarded_until_ = 0;
            guarding_failed_ = true;
        }
        for (Consumer& one : consumers_) {
            if (one.due != 0 && now_ >= one.due) {
                one.due = 0;
                one.failed = true;
            }
        }
        settle();
    }
    /// Checks for missing nodes. When a node becomes missing, 1029h:1 (error behaviour) determines the new NMT state.
    bool settle() {
        const Failing before = failing_;
        failing_[0] = guarding_failed_;
        for (std::size_t i = 0; i < consumers_.size(); ++i) {
            failing_[i + 1] = consumers_[i].failed;
        }
        for (std::size_t i = 0; i < failing_.size(); ++i) {
            if (failing_[i] && !before[i]) {
                react();
            }
        }
        return true;
    }
    void react() {
        if (error_behaviour_ == 2) {
            state_ = stopped;
        } else if (error_behaviour_ == 0 && state_ == operational) {
            state_ = pre_operational;
        }
    }

    std::uint64_t now_{0};
    unsigned state_{0};
    unsigned heartbeat_ms_{0};
    std::uint64_t heartbeat_from_{0};
    unsigned guard_ms_{0};
    unsigned life_factor_{0};
    std::uint64_t guarded_until_{0};  ///< time in ms at which life guarding fails; 0: life guarding does not run
    bool guarding_failed_{false};
    bool toggle_{false};
    unsigned error_behaviour_{0};
    std::array<Consumer, 4> consumers_{};
    Failing failing_{};
    Said said_;
};

/// One step of an exchange. A generator or a fuzzer chooses its numbers freely.
struct Event {
    unsigned kind{0};  ///< see apply()
    unsigned a{0};     ///< up to FFh
    unsigned b{0};     ///< up to FFFFh
};
constexpr unsigned event_kinds = 9;

/// The frame that an event sends to the node. An event without a frame lets time pass.
struct EventFrame {
    unsigned id{0};
    bool remote{false};
    std::vector<std::uint8_t> data;
};

inline EventFrame sdo_write(unsigned index, unsigned sub, unsigned bytes, unsigned value) {
    EventFrame frame{0x605, false, std::vector<std::uint8_t>(8)};
    frame.data[0] = static_cast<std::uint8_t>(0x23U | ((4U - bytes) << 2U));
    frame.data[1] = static_cast<std::uint8_t>(index);
    frame.data[2] = static_cast<std::uint8_t>(index >> 8U);
    frame.data[3] = static_cast<std::uint8_t>(sub);
    for (unsigned i = 0; i < bytes; ++i) {
        frame.data[4 + i] = static_cast<std::uint8_t>(value >> (8U * i));
    }
    return frame;
}

inline unsigned command_of(const Event& event) {
    constexpr std::array<unsigned, 8> commands{0x01, 0x02, 0x80, 0x81, 0x82, 0x01, 0x01, 0x00};
    return commands[event.b % commands.size()];
}
/// Returns the node-ID that an NMT command addresses: mostly 5 (this node) or 0 (all nodes).
inline unsigned addressed_of(const Event& event) {
    return event.a % 4U == 3U ? event.a / 4U : (event.a % 2U) * node_id;
}
/// Returns the node-ID of a heartbeat producer, 0 to 7. The events that write 1016h (consumer heartbeat time) use the
/// same node-IDs.
inline unsigned producer_of(const Event& event) {
    return (event.a / 4U) % 8U;
}
inline unsigned time_of(const Event& event) {
    return event.b % 300U;
}

inline EventFrame frame_of(const Event& event) {
    switch (event.kind) {
        case 0:
            return {0,
                    false,
                    {static_cast<std::uint8_t>(command_of(event)), static_cast<std::uint8_t>(addressed_of(event))}};
        case 1:
            return sdo_write(0x1017, 0, 2, time_of(event));
        case 2:
            return sdo_write(0x100C, 0, 2, time_of(event));
        case 3:
            return sdo_write(0x100D, 0, 1, event.a % 4U);
        case 4:
            return sdo_write(0x1016, 1 + event.a % 4U, 4, producer_of(event) << 16U | time_of(event));
        case 5:
            return sdo_write(0x1029, 1, 1, event.a % 4U);
        case 6:
            return {0x705, true, {}};
        case 7:
            return {0x700U + producer_of(event), false, {static_cast<std::uint8_t>(event.b)}};
        default:
            return {};
    }
}

/// Returns the time that passes in an event without a frame, in ms.
inline std::uint64_t pause_of(const Event& event) {
    return event.kind == 8 ? event.b % 700U : 0U;
}

/// Applies the event to the model.
inline void apply(Node& node, const Event& event) {
    switch (event.kind) {
        case 0:
            return node.command(command_of(event), addressed_of(event));
        case 1:
            return static_cast<void>(node.write_heartbeat_time(time_of(event)));
        case 2:
            return static_cast<void>(node.write_guard_time(time_of(event)));
        case 3:
            return static_cast<void>(node.write_life_factor(event.a % 4U));
        case 4:
            return static_cast<void>(node.write_consumer(event.a % 4U, producer_of(event), time_of(event)));
        case 5:
            return static_cast<void>(node.write_error_behaviour(event.a % 4U));
        case 6:
            return node.guard();
        case 7:
            return node.heartbeat_of(producer_of(event));
        default:
            return node.pass(pause_of(event));
    }
}

}  // namespace canproof::naive_error_control
