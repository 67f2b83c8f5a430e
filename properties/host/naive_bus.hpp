// SPDX-License-Identifier: Apache-2.0
// A naive CAN bus: a list of stations and a clock in whole microseconds. Frames are strings of bits, arbitration
// compares them bit by bit, the CRC is a long division.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "firmware/canopen/frame.hpp"

namespace canproof::host {

/// Returns `count` bits of a number, the highest first.
inline std::string naive_bits(std::uint64_t value, unsigned count) {
    std::string bits;
    for (unsigned i = count; i-- > 0;) {
        bits += ((value >> i) % 2U == 1U) ? '1' : '0';
    }
    return bits;
}

/// Returns identifier, RTR and IDE as bits on the bus. 0 is dominant, so the smaller text wins arbitration.
inline std::string naive_arbitration_field(const Frame& frame) {
    const std::string rtr = frame.remote ? "1" : "0";
    return frame.extended ? naive_bits(frame.id / 262144U, 11) + "11" + naive_bits(frame.id % 262144U, 18) + rtr
                          : naive_bits(frame.id, 11) + rtr + "0";
}

/// Returns the CRC of the bits: the remainder of a long division by the polynomial 1100010110011001.
inline std::string naive_crc(std::string bits) {
    const std::string divisor = "1100010110011001";
    const std::size_t places = bits.size();
    bits += std::string(15, '0');
    for (std::size_t at = 0; at < places; ++at) {
        for (std::size_t i = 0; bits[at] == '1' && i < divisor.size(); ++i) {
            // the text `divisor` has the coefficient of the highest power at its end
            const std::size_t place = at + divisor.size() - 1U - i;
            bits[place] = bits[place] == divisor[divisor.size() - 1U - i] ? '0' : '1';
        }
    }
    return bits.substr(places);
}

/// Returns the number of bits from start to end of the frame, stuff bits included.
inline unsigned naive_frame_bits(const Frame& frame) {
    std::string bits = "0" + naive_arbitration_field(frame) + (frame.extended ? "00" : "0");
    bits += naive_bits(frame.length, 4);
    for (std::size_t i = 0; i < frame.length && !frame.remote; ++i) {
        bits += naive_bits(frame.data[i], 8);
    }
    std::string wire;
    for (const char bit : bits + naive_crc(bits)) {
        wire += bit;
        const std::string last = wire.size() < 5 ? "" : wire.substr(wire.size() - 5);
        if (last == "00000" || last == "11111") {
            wire += bit == '0' ? '1' : '0';
        }
    }
    return static_cast<unsigned>(wire.size()) + 10U;  // CRC delimiter, ACK, ACK delimiter, end of frame (7)
}

/// Probabilities of bus faults, and the seed of the random numbers.
struct NaiveFaults {
    double corrupted{0.0};
    double lost{0.0};
    double bus_off{0.0};
    std::uint64_t seed{1};
};

class NaiveBus {
  public:
    struct Heard {
        std::uint64_t us;
        Frame frame;
    };
    struct Station {
        std::string name;
        bool gateway{false};
        std::deque<std::pair<std::uint64_t, Frame>>
            queue;  ///< frames, each with the time at which it became the first of the queue
        std::vector<Heard> heard;
        std::vector<std::pair<std::uint64_t, int>> states;  ///< 0 active, 1 warning, 2 passive, 3 bus-off
        std::vector<bool> overruns;
        unsigned transmit_errors{0};
        unsigned receive_errors{0};
        int state{0};
        bool overrun{false};
        std::uint64_t off_until{0};
        std::uint64_t suspended_until{0};
    };
    struct Sent {
        std::uint64_t us;
        std::string sender;
        Frame frame;
    };

    NaiveBus(std::uint64_t us_per_bit, const NaiveFaults& faults)
        : bit_{us_per_bit}, faults_{faults}, draws_{faults.seed} {
        add("outside", true);
    }

    /// Adds a station and returns its number. No later station gets this number.
    int add(const std::string& name, bool gateway) {
        Station station;
        station.name = name;
        station.gateway = gateway;
        stations_.emplace(next_number_, station);
        return next_number_++;
    }
    void remove(int number, std::uint64_t now) {
        if (on_wire_ && sender_ == number) {
            cut(now);
        }
        stations_.erase(number);
    }
    void send(int number, const Frame& frame, std::uint64_t now) {
        stations_.at(number).queue.emplace_back(now, frame);
    }
    void switch_off(int number, std::uint64_t now) {
        stations_.at(number).transmit_errors = 256;
        if (on_wire_ && sender_ == number) {
            cut(now);
        }
        look_at_state(stations_.at(number), now);
    }

    /// Performs everything that is due up to and including `now`.
    void run_to(std::uint64_t now) {
        for (bool any = true; any;) {
            any = recover_first(now) || end_frame(now) || start_frame(now);
        }
    }

    const Station& station(int number) const { return stations_.at(number); }
    const std::vector<Sent>& sent() const { return sent_; }
    std::uint64_t errors() const { return errors_; }
    std::uint64_t worst_latency() const { return worst_latency_; }
    /// Returns the bus load from 0 to 1: the share of the last second before `now` in which a frame or its intermission
    /// occupied the bus.
    double load(std::uint64_t now) const {
        const std::uint64_t from = now < 1000000U ? 0U : now - 1000000U;
        std::uint64_t used = on_wire_ ? now - std::max(start_, from) : 0U;
        for (const auto& [first, last] : taken_) {  // occupied times, sorted and without overlap
            used += last > from ? std::min(last, now) - std::max(first, from) : 0U;
        }
        return now == 0U ? 0.0 : static_cast<double>(used) / static_cast<double>(now - from);
    }

  private:
    bool happens(double probability) {
        return probability > 0.0 && static_cast<double>(draws_() >> 32U) < probability * 4294967296.0;
    }

    /// Performs the earliest recovery from bus-off that is due by `now`, unless a frame begins or ends before.
    bool recover_first(std::uint64_t now) {
        Station* first = nullptr;
        for (auto& [number, one] : stations_) {
            if (one.state == 3 && (first == nullptr || one.off_until < first->off_until)) {
                first = &one;
            }
        }
        const std::uint64_t next = on_wire_ ? end_ : next_start();
        if (first == nullptr || first->off_until > now || first->off_until > next) {
            return false;
        }
        first->transmit_errors = first->receive_errors = 0;
        first->suspended_until = std::max(first->suspended_until, first->off_until);
        look_at_state(*first, first->off_until);
        return true;
    }

    /// Returns the time at which the next frame begins if no event comes before.
    std::uint64_t next_start() const {
        std::uint64_t earliest = ~std::uint64_t{0};
        for (const auto& [number, one] : stations_) {
            if (one.state != 3 && !one.queue.empty()) {
                earliest = std::min(earliest, std::max({free_from_, one.suspended_until, one.queue.front().first}));
            }
        }
        return earliest;
    }

    bool start_frame(std::uint64_t now) {
        const std::uint64_t at = next_start();
        if (on_wire_ || at > now) {
            return false;
        }
        std::string best = "2";
        for (const auto& [number, one] : stations_) {
            const bool bids =
                one.state != 3 && !one.queue.empty() && std::max(one.suspended_until, one.queue.front().first) <= at;
            if (bids && naive_arbitration_field(one.queue.front().second) < best) {
                best = naive_arbitration_field(one.queue.front().second);
                sender_ = number;
            }
        }
        on_wire_ = true;
        start_ = at;
        const unsigned length = naive_frame_bits(stations_.at(sender_).queue.front().second);
        corrupted_ = happens(faults_.corrupted);
        // an error frame takes 20 bits: the error flags and the delimiter
        const std::uint64_t used = corrupted_ ? 1U + draws_() % length + 20U : length;
        end_ = at + used * bit_;
        return true;
    }

    bool end_frame(std::uint64_t now) {
        if (!on_wire_ || end_ > now) {
            return false;
        }
        on_wire_ = false;
        free_from_ = end_ + 3U * bit_;
        taken_.emplace_back(start_, free_from_);
        Station& from = stations_.at(sender_);
        const bool waits_longer = from.gateway || from.state >= 2;
        from.suspended_until = waits_longer ? free_from_ + 8U * bit_ : 0U;
        if (corrupted_) {
            ++errors_;
            from.transmit_errors += from.gateway ? 0U : 8U;
            tell_error(&from);
            if (!from.gateway) {
                look_at_state(from, end_);
            }
        } else {
            arrive(from);
        }
        return true;
    }

    /// Interrupts the running frame when its sender leaves the bus. The other stations detect an error.
    void cut(std::uint64_t now) {
        on_wire_ = false;
        ++errors_;
        end_ = now;
        free_from_ = now + 23U * bit_;
        taken_.emplace_back(start_, free_from_);
        tell_error(&stations_.at(sender_));
    }

    void tell_error(const Station* sender) {
        for (auto& [number, one] : stations_) {
            if (&one != sender && !one.gateway && one.state != 3) {
                one.receive_errors = std::min(one.receive_errors + 1U, 256U);
                look_at_state(one, end_);
            }
        }
    }

    void arrive(Station& from) {
        const auto [since, frame] = from.queue.front();
        worst_latency_ = std::max(worst_latency_, end_ - since);
        from.queue.pop_front();
        if (!from.queue.empty()) {
            from.queue.front().first = std::max(from.queue.front().first, end_);
        }
        sent_.push_back({end_, from.name, frame});
        if (!from.gateway) {
            from.transmit_errors -= from.transmit_errors > 0U ? 1U : 0U;
            from.transmit_errors = happens(faults_.bus_off) ? 256U : from.transmit_errors;
            look_at_state(from, end_);
        }
        const bool loses = happens(faults_.lost);
        const std::uint64_t loser = loses ? draws_() % stations_.size() : 0U;
        std::uint64_t place = 0;
        for (auto& [number, one] : stations_) {
            const bool misses = loses && place++ == loser && !one.gateway;
            if (&one != &from && one.state != 3) {
                take(one, frame, misses);
            }
        }
    }

    void take(Station& one, const Frame& frame, bool misses) {
        if (misses != one.overrun) {
            one.overruns.push_back(misses);
            one.overrun = misses;
        }
        if (misses) {
            return;
        }
        one.receive_errors = one.receive_errors > 127U ? 119U : one.receive_errors > 0U ? one.receive_errors - 1U : 0U;
        look_at_state(one, end_);
        one.heard.push_back({end_, frame});
    }

    void look_at_state(Station& one, std::uint64_t now) {
        const unsigned worst = std::max(one.transmit_errors, one.receive_errors);
        const int state = one.transmit_errors > 255U ? 3 : worst > 127U ? 2 : worst > 95U ? 1 : 0;
        if (state != one.state) {
            one.states.emplace_back(now, state);
            one.state = state;
            if (state == 3) {
                one.queue.clear();
                one.off_until = now + 128U * 11U * bit_;
            }
        }
    }

    std::uint64_t bit_;
    NaiveFaults faults_;
    std::mt19937_64 draws_;
    std::map<int, Station> stations_;  ///< by the number of the station, in the order of add()
    int next_number_{0};
    std::vector<Sent> sent_;
    bool on_wire_{false};
    bool corrupted_{false};
    int sender_{0};
    std::uint64_t start_{0};
    std::uint64_t end_{0};
    std::vector<std::pair<std::uint64_t, std::uint64_t>>
        taken_;  ///< times from the start of each frame to the end of its intermission
    std::uint64_t free_from_{0};
    std::uint64_t errors_{0};
    std::uint64_t worst_latency_{0};
};

}  // namespace canproof::host
