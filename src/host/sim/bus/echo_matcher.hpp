// SPDX-License-Identifier: Apache-2.0
// Finds the sender of a frame that the bus returns to this program. Stores the frames that nodes have sent until they
// come back.
#pragma once

#include <algorithm>
#include <deque>
#include <unordered_map>

#include "firmware/canopen/frame.hpp"

namespace canproof::host {

template <typename Owner>
class EchoMatcher {
  public:
    void sent(const Frame& frame, Owner owner) {
        std::deque<Sent>& open = open_[key(frame)];
        if (open.size() == most_open) {
            open.pop_front();
        }
        open.push_back({frame, owner});
    }
    /// Returns the node that has sent the frame; `nobody` when no node has. Each sent frame is recognised once.
    Owner match(const Frame& frame, Owner nobody) {
        const auto of_identifier = open_.find(key(frame));
        if (of_identifier == open_.end()) {
            return nobody;
        }
        std::deque<Sent>& open = of_identifier->second;
        const auto found =
            std::find_if(open.begin(), open.end(), [&](const Sent& one) { return same(one.frame, frame); });
        if (found == open.end()) {
            return nobody;
        }
        const Owner owner = found->owner;
        open.erase(found);
        return owner;
    }

  private:
    // Greatest number of sent frames with one identifier that may still come back. A socket cannot contain this number
    // of unread frames, so an older frame has been lost.
    static constexpr std::size_t most_open = 1U << 17U;
    struct Sent {
        Frame frame;
        Owner owner;
    };
    static std::uint32_t key(const Frame& frame) {
        return (frame.id << 2U) | (frame.extended ? 2U : 0U) | (frame.remote ? 1U : 0U);
    }
    static bool same(const Frame& a, const Frame& b) {
        return a.length == b.length &&
               (a.remote || std::equal(a.data.begin(), a.data.begin() + a.length, b.data.begin()));
    }

    std::unordered_map<std::uint32_t, std::deque<Sent>> open_;
};

}  // namespace canproof::host
