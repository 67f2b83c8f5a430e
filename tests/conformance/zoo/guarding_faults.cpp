// SPDX-License-Identifier: Apache-2.0
// Faults of node guarding and life guarding.
#include "tests/conformance/zoo/distortions.hpp"
#include "tests/conformance/zoo/faults.hpp"

namespace canproof::test::zoo {

namespace {

constexpr unsigned toggle = 0x80;

bool is_request(const WrongSlave& slave, const Frame& frame) {
    return frame.remote && !frame.extended && frame.id == error_control + slave.node_id();
}

bool is_answer(const WrongSlave& slave, const Frame& frame) {
    return is_data(frame, error_control + slave.node_id()) && !is_boot_up(frame, slave.node_id());
}

Distortion answers_guarding_otherwise(FrameChange change) {
    return says([change = std::move(change)](WrongSlave& slave, const Frame& frame) {
        slave.say(is_answer(slave, frame) ? change(slave, frame) : frame);
    });
}

Frame without_toggle(WrongSlave&, const Frame& frame) {
    return with_byte(frame, 0, frame.data[0] & ~toggle);
}

Frame with_other_toggle(WrongSlave&, const Frame& frame) {
    return with_byte(frame, 0, frame.data[0] ^ toggle);
}

/// Makes the slave continue the toggle bit after a reset, where a correct slave restarts it at 0.
Frame with_kept_toggle(WrongSlave& slave, const Frame& frame) {
    const unsigned next = slave.notes[0];
    slave.notes[0] = next ^ toggle;
    return with_byte(frame, 0, (frame.data[0] & ~toggle) | next);
}

Frame always_pre_operational(WrongSlave&, const Frame& frame) {
    return with_byte(frame, 0, (frame.data[0] & toggle) | 0x7FU);
}

Frame of_two_bytes(WrongSlave&, const Frame& frame) {
    return with_length(frame, 2);
}

/// Makes the slave answer guarding requests also while 1017h (producer heartbeat time) is not 0.
void answer_beside_heartbeat(WrongSlave& slave, const Frame& frame) {
    if (is_request(slave, frame) && slave.dictionary().read(0x1017, 0) != 0) {
        slave.say(with_byte(data_frame(frame.id, 1), 0, static_cast<unsigned>(slave.state())));
    } else {
        slave.pass(frame);
    }
}

void answer_for_next_node(WrongSlave& slave, const Frame& frame) {
    const bool others = is_request(slave, with_id(frame, frame.id - 1));
    slave.pass(others ? with_id(frame, frame.id - 1) : frame);
}

bool is_guarding_request(WrongSlave& slave, const Frame& frame) {
    return is_request(slave, frame);
}

}  // namespace

Faults guarding_faults() {
    const std::string life = "605#2B0C100064000000 605#2F0D100002000000 705#R ";  // 100 ms, factor 2
    const std::string failed = "200:085#3081110100000000";
    return {
        {"guarding-ignored", "guarding", "does not answer guarding requests", "705#R", "705#7F", "",
         is_deaf_to(is_guarding_request)},
        {"guarding-toggle-stuck", "guarding", "does not alternate the toggle", "705#R 705#R", "705#FF", "705#7F",
         answers_guarding_otherwise(without_toggle)},
        {"guarding-toggle-first", "guarding", "begins with toggle 1", "705#R", "705#7F", "705#FF",
         answers_guarding_otherwise(with_other_toggle)},
        {"guarding-toggle-kept", "guarding", "goes on with the toggle after reset communication",
         "705#R 000#8205 705#R", "705#7F", "705#FF", answers_guarding_otherwise(with_kept_toggle)},
        {"guarding-state", "guarding", "always names Pre-operational", "000#0205 705#R", "705#04", "705#7F",
         answers_guarding_otherwise(always_pre_operational)},
        {"guarding-length", "guarding", "answers with two bytes", "705#R", "705#7F", "705#7F00",
         answers_guarding_otherwise(of_two_bytes)},
        {"guarding-beside-heartbeat", "guarding", "answers although it produces a heartbeat",
         "605#2B171000E8030000 705#R", "", "705#7F", hears(answer_beside_heartbeat)},
        {"guarding-other-node", "guarding", "answers requests to the next node", "706#R", "", "705#7F",
         hears(answer_for_next_node)},
        {"life-ignored", "guarding", "does not notice that guarding ends", life + "+200", failed, "",
         works_with(object(0x100D), always(0))},
        {"life-late", "guarding", "notices after one and a half times the life time", life + "+250", failed, "",
         works_with(object(0x100C), percent(150))},
        {"life-early", "guarding", "notices after half the life time", life + "+150", "", "100:085#3081110100000000",
         works_with(object(0x100C), percent(50))},
    };
}

}  // namespace canproof::test::zoo
