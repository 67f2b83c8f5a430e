// SPDX-License-Identifier: Apache-2.0
// The senders that wait for the bus, in the order in which they win the arbitration.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <unordered_map>
#include <utility>

#include "firmware/canopen/frame.hpp"
#include "host/sim/bus/can_bits.hpp"

namespace canproof::host {

/// A sender is a number. Of two senders with the same identifier, the one with the lower number wins.
class WaitingLine {
  public:
    using Place = std::pair<std::uint32_t, std::size_t>;  ///< arbitration rank, sender

    /// Sets the next frame of a sender; nullptr means that it has none.
    void set(std::size_t sender, const Frame* frame) {
        if (const auto known = ranks_.extract(sender)) {
            places_.erase({known.mapped(), sender});
        }
        if (frame != nullptr) {
            const std::uint32_t rank = arbitration_rank(*frame);
            ranks_.emplace(sender, rank);
            places_.emplace(rank, sender);
        }
    }
    bool has(std::size_t sender) const { return ranks_.count(sender) != 0U; }
    /// Returns the waiting senders, the winner first.
    const std::set<Place>& places() const { return places_; }

  private:
    std::unordered_map<std::size_t, std::uint32_t> ranks_;
    std::set<Place> places_;
};

}  // namespace canproof::host
