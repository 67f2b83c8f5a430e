// SPDX-License-Identifier: Apache-2.0
#include "tests/conformance/zoo/distortions.hpp"

#include <utility>

namespace canproof::test::zoo {

Distortion hears(FrameHook hear) {
    return {{}, std::move(hear), {}};
}
Distortion says(FrameHook say) {
    return {{}, {}, std::move(say)};
}
Distortion hears_and_says(FrameHook hear, FrameHook say) {
    return {{}, std::move(hear), std::move(say)};
}
Distortion has_dictionary(std::function<void(host::Part&)> alter) {
    return {std::move(alter), {}, {}};
}

Distortion is_deaf_to(FrameTest which) {
    return hears([which = std::move(which)](WrongSlave& slave, const Frame& frame) {
        if (!which(slave, frame)) {
            slave.pass(frame);
        }
    });
}

Distortion keeps_back(FrameTest which) {
    return says([which = std::move(which)](WrongSlave& slave, const Frame& frame) {
        if (!which(slave, frame)) {
            slave.say(frame);
        }
    });
}

Distortion answers_otherwise(FrameChange change) {
    return says([change = std::move(change)](WrongSlave& slave, const Frame& frame) {
        slave.say(is_sdo_answer(slave, frame) ? change(slave, frame) : frame);
    });
}

Distortion takes_requests_as(FrameChange change) {
    return hears([change = std::move(change)](WrongSlave& slave, const Frame& frame) {
        slave.pass(is_sdo_request(slave, frame) ? change(slave, frame) : frame);
    });
}

Distortion aborts_with(std::uint32_t code, std::uint32_t other) {
    return answers_otherwise(
        [=](WrongSlave&, const Frame& frame) { return is_abort(frame, code) ? with_value(frame, other) : frame; });
}

Distortion confirms_refused(ObjectTest which, std::uint32_t code) {
    return answers_otherwise([=](WrongSlave& slave, const Frame& frame) {
        const bool refused = is_abort(frame, code) && which(index_of(frame), sub_of(frame));
        return refused ? confirmation(slave.node_id(), frame) : frame;
    });
}

Distortion works_with(ObjectTest which, ValueChange change) {
    const auto key = [](const Frame& frame) { return std::uint32_t{index_of(frame)} << 8U | sub_of(frame); };
    const auto hear = [=](WrongSlave& slave, const Frame& frame) {
        if (!is_sdo_request(slave, frame) || !is_expedited_download(frame) || !which(index_of(frame), sub_of(frame))) {
            slave.pass(frame);
            return;
        }
        slave.notes[key(frame)] = value_of(frame);
        slave.pass(with_value(frame, change(value_of(frame))));
    };
    const auto say = [=](WrongSlave& slave, const Frame& frame) {
        const auto written = slave.notes.find(key(frame));
        const bool read_back = is_sdo_answer(slave, frame) && is_expedited_answer(frame) &&
                               which(index_of(frame), sub_of(frame)) && written != slave.notes.end() &&
                               value_of(frame) == change(written->second);
        slave.say(read_back ? with_value(frame, written->second) : frame);
    };
    return hears_and_says(hear, say);
}

}  // namespace canproof::test::zoo
