// Which bit rate a bus has whose nodes disagree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>

namespace canproof::host {

/// Each node votes for the rate of its controller, in bit/s; 0 is no vote.
class BitRateVote {
  public:
    void add(std::uint32_t rate) {
        if (rate != 0U) {
            ++votes_[rate];
        }
    }
    /// The rate that most nodes have; `present` on a tie with it, or when nobody votes.
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
