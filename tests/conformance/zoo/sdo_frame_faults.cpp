// SPDX-License-Identifier: Apache-2.0
// Faults in the frames of the SDO server: wrong fields, late answers, missing answers.
#include "tests/conformance/zoo/distortions.hpp"
#include "tests/conformance/zoo/faults.hpp"

namespace canproof::test::zoo {

namespace {

/// Makes the slave serve a request of fewer than eight bytes: it takes the missing bytes from the previous request.
void fill_short_requests(WrongSlave& slave, const Frame& frame) {
    if (!is_data(frame, sdo_requests + slave.node_id())) {
        slave.pass(frame);
        return;
    }
    slave.bytes.resize(8);
    Frame full = with_length(frame, 8);
    for (std::size_t at = 0; at < 8; ++at) {
        full.data[at] = at < frame.length ? frame.data[at] : slave.bytes[at];
        slave.bytes[at] = full.data[at];
    }
    slave.pass(full);
}

void answer_remote(WrongSlave& slave, const Frame& frame) {
    if (frame.id == sdo_requests + slave.node_id() && frame.remote) {
        slave.say(abort_of(slave.node_id(), data_frame(frame.id, 8), 0x05040001));
    } else {
        slave.pass(frame);
    }
}

void obey_extended(WrongSlave& slave, const Frame& frame) {
    Frame standard = frame;
    standard.extended = frame.extended && frame.id != sdo_requests + slave.node_id();
    slave.pass(standard);
}

void answer_when_stopped(WrongSlave& slave, const Frame& frame) {
    if (is_sdo_request(slave, frame) && slave.state() == NmtState::stopped) {
        slave.say(abort_of(slave.node_id(), frame, 0x08000022));
    } else {
        slave.pass(frame);
    }
}

void answer_client_abort(WrongSlave& slave, const Frame& frame) {
    slave.pass(frame);
    if (is_sdo_request(slave, frame) && is_abort(frame)) {
        slave.say(abort_of(slave.node_id(), frame, 0x08000000));
    }
}

Distortion names_object_of_request_before() {
    const auto hear = [](WrongSlave& slave, const Frame& frame) {
        if (is_sdo_request(slave, frame)) {
            slave.notes[0] = slave.notes[1];
            slave.notes[1] = static_cast<std::uint32_t>(field_le<1, 3>(frame.data));
        }
        slave.pass(frame);
    };
    const auto say = [](WrongSlave& slave, const Frame& frame) {
        Frame other = frame;
        if (is_sdo_answer(slave, frame) && is_abort(frame)) {
            set_field_le<1, 3>(other.data, slave.notes[0]);
        }
        slave.say(other);
    };
    return hears_and_says(hear, say);
}

/// Fills the four unused bytes of a download's answer with the data of the request.
Distortion leaves_stale_bytes() {
    const auto hear = [](WrongSlave& slave, const Frame& frame) {
        slave.notes[0] = value_of(frame);
        slave.pass(frame);
    };
    const auto say = [](WrongSlave& slave, const Frame& frame) {
        const bool confirms = is_sdo_answer(slave, frame) && command_of(frame) == 0x60;
        slave.say(confirms ? with_value(frame, slave.notes[0]) : frame);
    };
    return hears_and_says(hear, say);
}

Frame cut_to_value(WrongSlave&, const Frame& frame) {
    return is_expedited_answer(frame) ? with_length(frame, 4 + expedited_size(frame)) : frame;
}

Frame always_four_bytes(WrongSlave&, const Frame& frame) {
    return is_expedited_answer(frame) ? with_command(frame, 0x43) : frame;
}

Frame without_subindex(WrongSlave&, const Frame& frame) {
    return is_expedited_answer(frame) ? with_byte(frame, 3, 0) : frame;
}

Frame abort_to_next_node(WrongSlave&, const Frame& frame) {
    return is_abort(frame) ? with_id(frame, frame.id + 1) : frame;
}

void say_twice(WrongSlave& slave, const Frame& frame) {
    slave.say(frame);
    if (is_sdo_answer(slave, frame)) {
        slave.say(frame);
    }
}

bool is_fifth_answer(WrongSlave& slave, const Frame& frame) {
    return is_sdo_answer(slave, frame) && ++slave.notes[0] % 5 == 0;
}

bool is_unknown_command(WrongSlave& slave, const Frame& frame) {
    return is_sdo_request(slave, frame) && specifier_of(frame) == 7;
}

}  // namespace

Faults sdo_frame_faults() {
    return {
        {"sdo-size-of-byte", "sdo", "shows four bytes for values of one or two bytes", "605#4001100000000000",
         "585#4F01100000000000", "585#4301100000000000", answers_otherwise(always_four_bytes)},
        {"sdo-subindex-lost", "sdo", "names sub-index 0 in answers to uploads", "605#4018100100000000",
         "585#431810015F000000", "585#431810005F000000", answers_otherwise(without_subindex)},
        {"sdo-stale-download-bytes", "sdo", "leaves bytes of the request in answers to downloads",
         "605#2B17100064000000", "585#6017100000000000", "585#6017100064000000", leaves_stale_bytes()},
        {"sdo-answer-cut", "sdo", "sends answers to uploads with less than eight bytes", "605#4001100000000000",
         "585#4F01100000000000", "585#4F01100000", answers_otherwise(cut_to_value)},
        {"sdo-answer-missing", "sdo", "leaves out every fifth answer",
         "605#4001100000000000 605#4001100000000000 605#4001100000000000 605#4001100000000000 605#4001100000000000",
         "585#4F01100000000000", "", keeps_back(is_fifth_answer)},
        {"sdo-answer-twice", "sdo", "sends each answer twice", "605#4001100000000000", "", "585#4F01100000000000",
         says(say_twice)},
        {"sdo-other-node", "sdo", "sends aborts with the identifier of the next node", "605#4004100000000000",
         "585#8004100000000206", "586#8004100000000206", answers_otherwise(abort_to_next_node)},
        {"sdo-short-request", "sdo", "completes a request of less than eight bytes with those of an older one",
         "605#40001000", "", "585#4300100078563412", hears(fill_short_requests)},
        {"sdo-remote-answered", "sdo", "answers a remote frame", "605#R", "", "585#8000000001000405",
         hears(answer_remote)},
        {"sdo-extended-obeyed", "sdo", "obeys requests with a 29-bit identifier", "00000605#4000100000000000", "",
         "585#4300100078563412", hears(obey_extended)},
        {"sdo-answer-stopped", "sdo", "refuses requests in Stopped in place of silence",
         "000#0205 605#4000100000000000", "", "585#8000100022000008", hears(answer_when_stopped)},
        {"sdo-unknown-silent", "sdo", "does not answer an unknown command", "605#E000100000000000",
         "585#8000100001000405", "", is_deaf_to(is_unknown_command)},
        {"sdo-abort-answered", "sdo", "answers the client's abort", "605#8000100000000405", "", "585#8000100000000008",
         hears(answer_client_abort)},
        {"sdo-abort-object", "sdo", "names the object of the request before in an abort",
         "605#4000100000000000 605#4004100000000000", "585#8004100000000206", "585#8000100000000206",
         names_object_of_request_before()},
    };
}

}  // namespace canproof::test::zoo
