// SPDX-License-Identifier: Apache-2.0
#include "tests/conformance/zoo/lss_frames.hpp"

#include <utility>

namespace canproof::test::zoo {

Distortion follows_lss(Distortion distortion) {
    const auto hear = [inner = distortion.hear](WrongSlave& slave, const Frame& frame) {
        if (inner) {
            inner(slave, frame);
        } else {
            slave.pass(frame);
        }
        if (is_lss(frame, 0x04) && frame.data[1] <= 1) {
            slave.notes[lss_mode_note] = frame.data[1];
        }
    };
    const auto say = [inner = distortion.say](WrongSlave& slave, const Frame& frame) {
        if (is_boot_up(frame, slave.node_id())) {
            slave.notes[lss_mode_note] = 0;
        } else if (is_data(frame, lss_answers) && frame.data[0] == 0x44) {
            slave.notes[lss_mode_note] = 1;
        }
        if (inner) {
            inner(slave, frame);
        } else {
            slave.say(frame);
        }
    };
    return hears_and_says(hear, say);
}

Distortion serves_lss(std::function<bool(WrongSlave&, const Frame&)> serve) {
    return follows_lss(hears([serve = std::move(serve)](WrongSlave& slave, const Frame& frame) {
        if (!is_data(frame, lss_requests) || !serve(slave, frame)) {
            slave.pass(frame);
        }
    }));
}

Distortion answers_lss_otherwise(FrameChange change) {
    return says([change = std::move(change)](WrongSlave& slave, const Frame& frame) {
        slave.say(is_data(frame, lss_answers) ? change(slave, frame) : frame);
    });
}

}  // namespace canproof::test::zoo
