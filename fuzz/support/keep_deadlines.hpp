// SPDX-License-Identifier: Apache-2.0
// Advances time for a device whose driver calls it at every deadline.
#pragma once

#include "firmware/base/time.hpp"
#include "fuzz/support/require.hpp"

namespace canproof::fuzz {

/// Moves `now` to `end`. `drain` takes what the device sends at each deadline on the way.
template <typename Device, typename Drain>
void keep_deadlines(Device& device, Instant& now, Instant end, const Drain& drain) {
    for (unsigned at_once = 0; device.next_deadline() <= end;) {
        at_once = device.next_deadline() > now ? 0 : at_once + 1;
        require(at_once < 4, "a block upload fills the queue no more often");
        now = device.next_deadline() > now ? device.next_deadline() : now;
        device.advance(now);
        require(device.next_deadline() > now, "what is due gets done");
        drain();
    }
    now = end;
}

}  // namespace canproof::fuzz
