// SPDX-License-Identifier: Apache-2.0
// Checks how canproof recognises the echoes of the frames that it sent, in a run and in a replay. A plain list of the
// sent frames gives the expected result: an echo belongs to the oldest equal frame in the list.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

#include "host/sim/bus/echo_matcher.hpp"
#include "host/sim/replay/own_frames.hpp"

namespace canproof::host {

namespace {

constexpr int nobody = -1;

struct Listed {
    Frame frame{};
    int owner{0};
    std::uint64_t us{0};
};

/// Returns one of a few frames. Some are equal; some differ only in format, remote request, length or last byte.
Frame one_of_few() {
    Frame frame{};
    frame.id = *rc::gen::element<std::uint32_t>(0x000, 0x181, 0x182);
    frame.extended = *rc::gen::arbitrary<bool>();
    frame.remote = *rc::gen::arbitrary<bool>();
    frame.length = *rc::gen::element<std::uint8_t>(0, 1, 2, 8);
    if (frame.length != 0U && !frame.remote) {
        frame.data[frame.length - 1U] = *rc::gen::element<std::uint8_t>(0, 1);
    }
    return frame;
}

/// Returns whether two frames are equal. A remote frame has no data bytes, whatever its buffer contains.
bool is_same(const Frame& a, const Frame& b) {
    bool same = a.id == b.id && a.extended == b.extended && a.remote == b.remote && a.length == b.length;
    for (std::size_t i = 0; i < a.length && !a.remote; ++i) {
        same = same && a.data[i] == b.data[i];
    }
    return same;
}

/// Removes the oldest frame that is equal to `frame` from the list. Returns who sent it, or `nobody`.
int take(std::vector<Listed>& list, const Frame& frame) {
    const auto found =
        std::find_if(list.begin(), list.end(), [&](const Listed& one) { return is_same(one.frame, frame); });
    if (found == list.end()) {
        return nobody;
    }
    const int owner = found->owner;
    list.erase(found);
    return owner;
}

}  // namespace

RC_GTEST_PROP(OwnFramesLaw, EchoIsMatchedToTheOldestEqualSentFrame, ()) {
    EchoMatcher<int> matcher;
    std::vector<Listed> list;
    for (int i = *rc::gen::inRange(1, 60); i > 0; --i) {
        const Frame frame = one_of_few();
        if (*rc::gen::arbitrary<bool>()) {
            const int owner = *rc::gen::inRange(0, 3);
            matcher.sent(frame, owner);
            list.push_back({frame, owner, 0});
        } else {
            RC_ASSERT(matcher.match(frame, nobody) == take(list, frame));
        }
    }
}

RC_GTEST_PROP(OwnFramesLaw, OwnFrameIsRecognisedOnceAndOnlyWithinAMinuteOfItsSending, ()) {
    OwnFrames own;
    std::vector<Listed> list;
    std::uint64_t now = 0;
    for (int i = *rc::gen::inRange(1, 60); i > 0; --i) {
        now += *rc::gen::element<std::uint64_t>(0, 1000, 29999999, 30000000, 30000001, 60000000, 60000001);
        const Frame frame = one_of_few();
        if (*rc::gen::arbitrary<bool>()) {
            own.sent(frame, Instant{now});
            list.push_back({frame, 0, now});
        } else {
            list.erase(
                std::remove_if(list.begin(), list.end(), [&](const Listed& one) { return one.us + 60000000U < now; }),
                list.end());
            RC_ASSERT(own.match(frame, Instant{now}) == (take(list, frame) != nobody));
        }
    }
}

}  // namespace canproof::host
