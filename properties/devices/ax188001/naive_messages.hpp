// SPDX-License-Identifier: Apache-2.0
// Naive errors of the AX188001 (manual, 3.2.4): 1001h (error register), 1003h (error list) and emergency
// messages with code, channel and description. Shares no code with the firmware.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

namespace canproof::naive_tcs {

/// A row of Table 5, with the description from Table 6.
struct ErrorKind {
    unsigned code;
    unsigned channel;
    unsigned description;
};

constexpr std::size_t overrun_error = 0;
constexpr std::size_t first_channel_error = 1;  ///< open circuit, high, low and shutdown of channel 1, then of channel
                                                ///< 2
constexpr std::size_t first_unit_error = 9;     ///< FD1 to FD3
constexpr std::size_t bus_off_over = 12;        ///< end of bus-off: reported once, never active
constexpr std::array<ErrorKind, 13> error_kinds{{{0x8110, 0, 0x00},
                                                 {0xF001, 1, 0x00},
                                                 {0xF011, 1, 0x10},
                                                 {0xF011, 1, 0x20},
                                                 {0xF011, 1, 0x40},
                                                 {0xF001, 2, 0x00},
                                                 {0xF011, 2, 0x10},
                                                 {0xF011, 2, 0x20},
                                                 {0xF011, 2, 0x40},
                                                 {0x4200, 1, 0x10},
                                                 {0x3100, 2, 0x10},
                                                 {0x3100, 3, 0x20},
                                                 {0x8400, 0, 0x00}}};

class Messages {
  public:
    /// Appends the emergency messages, as frames of node 127 in text form, to `sent`.
    explicit Messages(std::vector<std::string>& sent) : sent_{&sent} {}

    void forget_all() {
        active_.fill(false);
        waiting_.clear();
        list_.clear();
    }
    void allow(bool allowed) {
        allowed_ = allowed;
        flush();
    }
    bool is_active(std::size_t error) const { return active_[error]; }
    void set(std::size_t error, bool present) {
        if (active_[error] == present) {
            return;
        }
        active_[error] = present;
        const ErrorKind& kind = error_kinds[error];
        const std::uint32_t entry = (kind.description << 24U) | (kind.channel << 16U) | kind.code;
        if (present) {
            list_.push_front(entry);
            list_.resize(std::min<std::size_t>(list_.size(), 9));
        } else {
            list_.erase(std::remove(list_.begin(), list_.end(), entry), list_.end());
        }
        announce({error, !present});
        flush();
    }
    void tell_bus_off_over() {
        announce({bus_off_over, false});
        flush();
    }
    void empty_list() { list_.clear(); }

    unsigned error_register() const { return std::find(active_.begin(), active_.end(), true) != active_.end() ? 1 : 0; }
    /// Returns the entries of 1003h (predefined error field), the latest error first.
    const std::deque<std::uint32_t>& list() const { return list_; }

  private:
    struct Waiting {
        std::size_t error;
        bool cured;
    };

    /// Queues a message. While the node is stopped, at most two messages of each error wait: one for the first state of
    /// the error and one for its present state.
    void announce(const Waiting& told) {
        std::vector<std::size_t> same;
        for (std::size_t i = 0; i < waiting_.size(); ++i) {
            if (waiting_[i].error == told.error) {
                same.push_back(i);
            }
        }
        if (!same.empty() && waiting_[same.back()].cured == told.cured) {
            return;
        }
        if (same.size() == 2) {
            waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(same.back()));
        } else {
            waiting_.push_back(told);
        }
    }
    void flush() {
        for (; allowed_ && !waiting_.empty(); waiting_.pop_front()) {
            const Waiting told = waiting_.front();
            const ErrorKind kind = told.cured ? ErrorKind{0, 0, 0} : error_kinds[told.error];
            sent_->push_back(fmt::format("0FF#{:02X}{:02X}{:02X}{:02X}{:02X}000000", kind.code & 0xFFU, kind.code >> 8U,
                                         error_register(), kind.channel, kind.description));
        }
    }

    std::vector<std::string>* sent_;
    bool allowed_{false};
    std::array<bool, error_kinds.size()> active_{};
    std::deque<Waiting> waiting_;
    std::deque<std::uint32_t> list_;
};

}  // namespace canproof::naive_tcs
