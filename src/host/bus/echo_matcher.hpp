// Which frames of a record are a node's own: those that it has sent and that have not yet been seen coming back.
#pragma once

#include <algorithm>
#include <deque>

#include "firmware/canopen/frame.hpp"

namespace canproof::host {

template <typename Owner>
class EchoMatcher {
  public:
    void sent(const Frame& frame, Owner owner) {
        if (open_.size() == most_open) {
            open_.pop_front();
        }
        open_.push_back({frame, owner});
    }
    /// Whose this frame is; `nobody` when nobody has sent it. Each frame sent is recognised once.
    Owner match(const Frame& frame, Owner nobody) {
        const auto found =
            std::find_if(open_.begin(), open_.end(), [&](const Sent& one) { return same(one.frame, frame); });
        if (found == open_.end()) {
            return nobody;
        }
        const Owner owner = found->owner;
        open_.erase(found);
        return owner;
    }

  private:
    // More than the transmit queues of some dozen nodes hold together: older ones never came back.
    static constexpr std::size_t most_open = 4096;
    struct Sent {
        Frame frame;
        Owner owner;
    };
    static bool same(const Frame& a, const Frame& b) {
        return a.id == b.id && a.extended == b.extended && a.remote == b.remote && a.length == b.length &&
               (a.remote || std::equal(a.data.begin(), a.data.begin() + a.length, b.data.begin()));
    }

    std::deque<Sent> open_;
};

}  // namespace canproof::host
