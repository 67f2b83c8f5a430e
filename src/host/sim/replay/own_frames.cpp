// SPDX-License-Identifier: Apache-2.0
#include "host/sim/replay/own_frames.hpp"

#include <functional>

namespace canproof::host {

std::size_t OwnFrames::Hash::operator()(const Content& one) const {
    // a multiplier of the hash: an odd number, half of whose bits are set
    constexpr std::uint64_t spread = 0x9E3779B97F4A7C15U;
    const std::uint64_t head = (std::uint64_t{one.id} << 32U) | one.form;
    return std::hash<std::uint64_t>{}((one.data * spread) ^ (head * spread >> 1U));
}

OwnFrames::Content OwnFrames::content_of(const Frame& frame) {
    Content content{0, frame.id,
                    std::uint32_t{frame.length} | (frame.extended ? 0x100U : 0U) | (frame.remote ? 0x200U : 0U)};
    for (std::size_t i = 0; i < frame.length && !frame.remote; ++i) {
        content.data |= std::uint64_t{frame.data[i]} << (8U * i);
    }
    return content;
}

void OwnFrames::sent(const Frame& frame, Instant now) {
    forget(now);
    const Content content = content_of(frame);
    ++counts_[content].open;
    order_.push_back({content, now});
}

bool OwnFrames::match(const Frame& frame, Instant now) {
    forget(now);
    const auto found = counts_.find(content_of(frame));
    if (found == counts_.end() || found->second.open == 0) {
        return false;
    }
    --found->second.open;
    ++found->second.seen;
    return true;
}

/// Removes frames that are older than `longest_wait` from `order_` and from the counts. match() always matches the
/// oldest of equal frames. So the oldest frame counts as seen if at least one frame equal to it was seen.
void OwnFrames::forget(Instant now) {
    while (!order_.empty() && order_.front().time + longest_wait < now) {
        const auto found = counts_.find(order_.front().content);
        Count& count = found->second;
        --(count.seen > 0 ? count.seen : count.open);
        if (count.seen == 0 && count.open == 0) {
            counts_.erase(found);
        }
        order_.pop_front();
    }
}

}  // namespace canproof::host
