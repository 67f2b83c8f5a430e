// SPDX-License-Identifier: Apache-2.0
// A naive CAN bus: a list of stations, and a clock in whole microseconds. Frames are strings of bits; arbitration
// compares these bit by bit; the CRC is computed by long division.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "properties/host/naive_frame.hpp"

namespace canproof::host {

/// Probabilities of bus faults, and the seed of the random numbers.
struct NaiveFaults {
    double corrupted{0.0};
    double lost{0.0};
    double bus_off{0.0};
    std::uint64_t seed{1};
};

class NaiveBus {
  public:
    /// An acceptance filter: accepts the identifiers of one format (11 or 29 bits) that equal `id` in the bits that are
    /// set in `mask`.
    struct Filter {
        std::uint32_t id;
        std::uint32_t mask;
        bool extended;
    };
    struct Heard {
        std::uint64_t us;
        Frame frame;
    };
    struct Station {
        std::string name;
        bool gateway{false};
        /// frames to send, each with the time at which it became the first in the queue
        std::deque<std::pair<std::uint64_t, Frame>> queue;
        std::vector<Heard> heard;
        std::vector<std::pair<std::uint64_t, int>> states;  ///< 0 active, 1 warning, 2 passive, 3 bus-off
        std::vector<bool> overruns;
        unsigned transmit_errors{0};
        unsigned receive_errors{0};
        int state{0};
        bool overrun{false};
        std::uint64_t off_until{0};
        std::uint64_t suspended_until{0};
        bool again{false};        ///< whether the first frame of the queue was corrupted and must be sent again
        std::uint64_t bit_us{0};  ///< length of a bit of this station's controller in us; 0: the same as on the bus
        bool fitted{true};        ///< whether the station had the bit rate of the bus at the last call of vote()
        std::vector<Filter> filters{{0U, 0U, false}, {0U, 0U, true}};

        bool wants(const Frame& frame) const {
            bool wanted = false;
            for (const Filter& one : filters) {
                wanted = wanted || (one.extended == frame.extended && ((one.id ^ frame.id) & one.mask) == 0U);
            }
            return wanted;
        }
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
    void set_filters(int number, const std::vector<Filter>& filters) { stations_.at(number).filters = filters; }
    void set_bit_us(int number, std::uint64_t us) {
        Station& one = stations_.at(number);
        one.bit_us = us;
        one.fitted = one.fitted && fits(one);
    }
    /// Makes the station bus-off. Does nothing if it is bus-off already.
    void switch_off(int number, std::uint64_t now) {
        stations_.at(number).transmit_errors = 256;
        if (on_wire_ && sender_ == number) {
            cut(now);
        }
        look_at_state(stations_.at(number), now);
    }

    /// Performs everything that is due up to and including `now`.
    void run_to(std::uint64_t now) {
        if (!on_wire_) {
            vote(now);
        }
        for (bool any = true; any;) {
            any = recover_first(now) || end_frame(now) || start_frame(now);
        }
    }

    const Station& station(int number) const { return stations_.at(number); }
    std::uint64_t bit_us() const { return bit_; }
    /// Returns whether a frame of the station is on the bus or must be repeated.
    bool is_sending(int number) const { return (on_wire_ && sender_ == number) || stations_.at(number).again; }
    /// Returns the time of the next event if nothing new happens before; the greatest number if there is no next event.
    std::uint64_t next_event() const {
        std::uint64_t next = on_wire_ ? end_ : next_start();
        for (const auto& [number, one] : stations_) {
            next = one.state == 3 ? std::min(next, one.off_until) : next;
        }
        return next;
    }
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

    bool fits(const Station& one) const { return one.bit_us == 0U || one.bit_us == bit_; }
    bool takes_part(const Station& one) const { return one.state != 3 && fits(one); }

    /// Sets the bus to the bit length that most stations have. On a tie, the present length stays if it is among the
    /// winners; otherwise the longest one wins (lowest bit rate).
    void vote(std::uint64_t now) {
        // sorted by the length of a bit, longest first: the lowest bit rate
        std::map<std::uint64_t, int, std::greater<>> votes;
        for (const auto& [number, one] : stations_) {
            votes[one.bit_us] += one.bit_us != 0U ? 1 : 0;
        }
        std::uint64_t best = bit_;
        for (const auto& [length, count] : votes) {
            best = count > (votes.count(best) != 0U ? votes.at(best) : 0) ? length : best;
        }
        bit_ = best;
        for (auto& [number, one] : stations_) {
            if (fits(one) && !one.fitted) {
                one.suspended_until = std::max(one.suspended_until, now);
            }
            one.fitted = fits(one);
        }
    }

    /// Performs the earliest recovery from bus-off that is due by `now`, unless a frame begins or ends before it.
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

    /// Returns the time at which the next frame begins if nothing else happens before.
    std::uint64_t next_start() const {
        std::uint64_t earliest = ~std::uint64_t{0};
        for (const auto& [number, one] : stations_) {
            if (takes_part(one) && !one.queue.empty()) {
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
                takes_part(one) && !one.queue.empty() && std::max(one.suspended_until, one.queue.front().first) <= at;
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
            from.again = true;
            from.transmit_errors += from.gateway ? 0U : 8U;
            tell_error(&from);
            if (!from.gateway) {
                look_at_state(from, end_);
            }
        } else {
            arrive(from);
        }
        vote(end_);
        return true;
    }

    /// Interrupts the frame on the bus, because its sender leaves the bus. The other stations detect an error.
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
            if (&one != sender && !one.gateway && takes_part(one)) {
                one.receive_errors = std::min(one.receive_errors + 1U, 256U);
                look_at_state(one, end_);
            }
        }
    }

    void arrive(Station& from) {
        const auto [since, frame] = from.queue.front();
        worst_latency_ = std::max(worst_latency_, end_ - since);
        from.queue.pop_front();
        from.again = false;
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
            if (&one != &from && takes_part(one)) {
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
        if (one.wants(frame)) {
            one.heard.push_back({end_, frame});
        }
    }

    void look_at_state(Station& one, std::uint64_t now) {
        const unsigned worst = std::max(one.transmit_errors, one.receive_errors);
        const int state = one.transmit_errors > 255U ? 3 : worst > 127U ? 2 : worst > 95U ? 1 : 0;
        if (state != one.state) {
            one.states.emplace_back(now, state);
            one.state = state;
            if (state == 3) {
                one.queue.clear();
                one.again = false;
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
        taken_;  ///< for each frame, the time from its start to the end of its intermission
    std::uint64_t free_from_{0};
    std::uint64_t errors_{0};
    std::uint64_t worst_latency_{0};
};

}  // namespace canproof::host
