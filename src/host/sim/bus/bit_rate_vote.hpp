// SPDX-License-Identifier: Apache-2.0
// Determines the bit rate of a bus on which nodes have different bit rates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>

namespace canproof::host {

/// Counts votes. Each node votes for the rate of its controller in bit/s; 0 is no vote.
class BitRateVote {
  public:
    void add(std::uint32_t rate) {
        if (rate != 0U) {
            ++votes_[rate];
        }
    }
    /// Returns the bit rate with the most votes. Returns `present` if no other rate has more votes, or if there is
    /// no vote.
    std::uint32_t outcome(std::uint32_t present) const {
        std::uint32_t best = present;
        for (const auto& [rate, count] : votes_) {
            const auto own = votes_.find(best);
            if (own == votes_.end() || count > own->second) {
                best = rate;
            }
        }
        return best;
    }

  private:
    std::map<std::uint32_t, std::size_t> votes_;
};

}  // namespace canproof::host
