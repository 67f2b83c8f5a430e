// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/heartbeat_consumer.hpp"

namespace canproof {

bool HeartbeatConsumer::is_consistent() const noexcept {
    Instant first{never};
    bool sound = failed_ < (1U << max_producers);
    for (std::size_t i = 0U; i < max_producers; ++i) {
        const Watch& watch = watches_[i];
        const bool is_watched = watch.identifier != 0U;
        const bool has_failed = ((failed_ >> i) & 1U) != 0U;
        sound = sound && (!is_watched || (any_ && (watch.identifier >= 0x701U) && (watch.identifier <= 0x77FU)));
        sound =
            sound && (is_watched ? ((watch.time.us >= 1000U) && (watch.time.us <= 65535000U)) : (watch.time.us == 0U));
        sound = sound && ((watch.deadline == never) || (is_watched && !has_failed)) && (is_watched || !has_failed);
        first = (watch.deadline < first) ? watch.deadline : first;
    }
    return sound && (next_ == first);
}

}  // namespace canproof
