// SPDX-License-Identifier: Apache-2.0
#include "host/sim/replay/own_frames.hpp"

#include <cstring>
#include <functional>
#include <string_view>
#include <type_traits>

namespace canproof::host {

std::size_t OwnFrames::Hash::operator()(const Content& one) const {
    static_assert(std::has_unique_object_representations_v<Content>, "equal contents must have equal bytes");
    return std::hash<std::string_view>{}({reinterpret_cast<const char*>(one.data()), sizeof one});
}

OwnFrames::Content OwnFrames::content_of(const Frame& frame) {
    const std::uint32_t form = frame.length | (frame.extended ? 0x100U : 0U) | (frame.remote ? 0x200U : 0U);
    Content content{frame.id, form};
    if (!frame.remote) {
        std::memcpy(content.data() + 2, frame.data.data(), frame.length);
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
