// SPDX-License-Identifier: Apache-2.0
// Faults of heartbeat producer and consumer, and of the reaction to a lost heartbeat that 1029h (error behaviour) sets.
#include "tests/conformance/zoo/distortions.hpp"
#include "tests/conformance/zoo/faults.hpp"

namespace canproof::test::zoo {

namespace {

bool is_heartbeat(const WrongSlave& slave, const Frame& frame) {
    return is_data(frame, error_control + slave.node_id()) && !is_boot_up(frame, slave.node_id());
}

Distortion beats_otherwise(FrameChange change) {
    return says([change = std::move(change)](WrongSlave& slave, const Frame& frame) {
        slave.say(is_heartbeat(slave, frame) ? change(slave, frame) : frame);
    });
}

Frame always_pre_operational(WrongSlave&, const Frame& frame) {
    return with_byte(frame, 0, 0x7F);
}

Frame toggling(WrongSlave& slave, const Frame& frame) {
    slave.notes[0] ^= 0x80U;
    return with_byte(frame, 0, (frame.data[0] & 0x7FU) | slave.notes[0]);
}

Frame of_two_bytes(WrongSlave&, const Frame& frame) {
    return with_length(frame, 2);
}

bool is_silent_when_stopped(WrongSlave& slave, const Frame& frame) {
    return is_heartbeat(slave, frame) && frame.data[0] == 4;
}

/// Makes the slave continue the heartbeat after a client has written 0 to 1017h (producer heartbeat time).
Frame without_end(WrongSlave& slave, const Frame& frame) {
    if (!is_expedited_download(frame) || index_of(frame) != 0x1017) {
        return frame;
    }
    slave.notes[0] = value_of(frame) != 0 ? value_of(frame) : slave.notes[0];
    return with_value(frame, slave.notes[0]);
}

/// Makes the slave monitor a heartbeat from the write of 1016h on. A correct slave starts with the first heartbeat.
void watch_at_once(WrongSlave& slave, const Frame& frame) {
    slave.pass(frame);
    const bool writes = is_sdo_request(slave, frame) && is_expedited_download(frame) && index_of(frame) == 0x1016;
    if (writes && (value_of(frame) & 0xFFFFU) != 0 && frame.data[6] >= 1 && frame.data[6] <= 127) {
        slave.pass(data_frame(error_control + frame.data[6], 1));
    }
}

}  // namespace

Faults heartbeat_faults() {
    const std::string produce = "605#2B17100064000000 ";         // 1017h producer heartbeat time: 100 ms
    const std::string watch = "605#2316100164000700 000#0105 ";  // 1016h:1 consumer heartbeat time: node 7, 100 ms
    const std::string beat = "707#05 ";
    const std::string lost = "100:085#3081110100000000";
    return {
        {"heartbeat-late", "heartbeat", "sends its heartbeat 5 % late", produce + "+200", "100:705#7F 200:705#7F",
         "105:705#7F", works_with(object(0x1017), percent(105))},
        {"heartbeat-early", "heartbeat", "sends its heartbeat 10 % early", produce + "+170", "100:705#7F", "90:705#7F",
         works_with(object(0x1017), percent(90))},
        {"heartbeat-missing", "heartbeat", "sends no heartbeat", produce + "+100", "100:705#7F", "",
         works_with(object(0x1017), always(0))},
        {"heartbeat-state", "heartbeat", "always names Pre-operational", produce + "000#0205 +100", "100:705#04",
         "100:705#7F", beats_otherwise(always_pre_operational)},
        {"heartbeat-toggle", "heartbeat", "toggles bit 7 of its heartbeat", produce + "+100", "100:705#7F",
         "100:705#FF", beats_otherwise(toggling)},
        {"heartbeat-length", "heartbeat", "sends a heartbeat of two bytes", produce + "+100", "100:705#7F",
         "100:705#7F00", beats_otherwise(of_two_bytes)},
        {"heartbeat-stopped", "heartbeat", "sends no heartbeat in Stopped", produce + "000#0205 +100", "100:705#04", "",
         keeps_back(is_silent_when_stopped)},
        {"heartbeat-no-end", "heartbeat", "goes on with its heartbeat when 1017h is 0",
         produce + "605#2B17100000000000 +100", "", "100:705#7F", takes_requests_as(without_end)},
        {"consumer-ignored", "heartbeat", "does not notice the loss of a heartbeat", watch + beat + "+100", lost, "",
         works_with(object(0x1016), [](std::uint32_t value) { return value & 0xFFFF0000U; })},
        {"consumer-slow", "heartbeat", "notices the loss of a heartbeat after twice the time", watch + beat + "+150",
         lost, "",
         works_with(object(0x1016),
                    [](std::uint32_t value) {
                        const std::uint32_t time = (value & 0xFFFFU) * 2;
                        return (value & 0xFFFF0000U) | (time > 0xFFFF ? 0xFFFFU : time);
                    })},
        {"consumer-fast", "heartbeat", "notices a loss after half the time", watch + beat + "+75", "",
         "50:085#3081110100000000",
         works_with(object(0x1016), [](std::uint32_t value) { return (value & 0xFFFF0000U) | (value & 0xFFFFU) / 2; })},
        {"consumer-at-once", "heartbeat", "watches a node that has not sent a heartbeat yet", watch + "+100", "", lost,
         hears(watch_at_once)},
        {"consumer-node-twice", "heartbeat", "lets two entries watch one node",
         "605#2316100164000700 605#2316100264000700", "585#8016100243000406", "585#6016100200000000",
         confirms_refused(object(0x1016), 0x06040043)},
        {"behaviour-ignored", "heartbeat", "leaves Operational at a loss although 1029h:01 is 1",
         "605#2F29100101000000 " + watch + beat + produce + "+200", "200:705#05", "200:705#7F",
         works_with(entry(0x1029, 1), always(0))},
        {"behaviour-no-stop", "heartbeat", "does not stop at a loss although 1029h:01 is 2",
         "605#2F29100102000000 " + watch + beat + produce + "+200", "200:705#04", "200:705#05",
         works_with(entry(0x1029, 1), always(1))},
    };
}

}  // namespace canproof::test::zoo
