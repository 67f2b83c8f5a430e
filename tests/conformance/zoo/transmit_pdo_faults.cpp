// SPDX-License-Identifier: Apache-2.0
// Faults of transmit PDOs: when and how they are sent.
#include "tests/conformance/zoo/distortions.hpp"
#include "tests/conformance/zoo/faults.hpp"
#include "tests/conformance/zoo/pdo_frames.hpp"

namespace canproof::test::zoo {

namespace {

constexpr std::uint32_t last_synchronous_type = 240;

bool is_tpdo(WrongSlave& slave, const Frame& frame) {
    return !frame.remote && pdo_of(slave, tpdo_communication, frame).has_value();
}

bool is_sync(WrongSlave& slave, const Frame& frame) {
    return is_data(frame, slave.dictionary().read(0x1005, 0) & 0x7FFU);
}

/// Makes the slave send its TPDOs of synchronous transmission types, or those of the other types. Sends the valid ones,
/// or, if `valid` is false, only those that are not valid.
void say_tpdos(WrongSlave& slave, bool synchronous, bool valid = true) {
    for (unsigned number = 0; number < pdo_count; ++number) {
        const bool at_sync = pdo_parameter(slave, tpdo_communication, number, 2) <= last_synchronous_type;
        if (is_valid_pdo(slave, tpdo_communication, number) == valid && at_sync == synchronous) {
            slave.say(tpdo_frame(slave, number));
        }
    }
}

/// Makes the slave send TPDOs in `state`, in which a correct slave sends none: at SYNC and when an object from 2000h on
/// is written.
Distortion sends_in(NmtState state) {
    return hears([state](WrongSlave& slave, const Frame& frame) {
        const bool is_state = slave.state() == state;
        const bool writes = is_sdo_request(slave, frame) && is_expedited_download(frame) && index_of(frame) >= 0x2000;
        slave.pass(frame);
        if (is_state && is_sync(slave, frame)) {
            say_tpdos(slave, true);
        }
        if (is_state && (writes || is_sync(slave, frame))) {
            say_tpdos(slave, false);
        }
    });
}

/// Makes the slave send TPDOs that are not valid at each SYNC.
void send_invalid(WrongSlave& slave, const Frame& frame) {
    slave.pass(frame);
    if (slave.state() == NmtState::operational && is_sync(slave, frame)) {
        say_tpdos(slave, true, false);
        say_tpdos(slave, false, false);
    }
}

bool is_tpdo_request(WrongSlave& slave, const Frame& frame) {
    return frame.remote && pdo_of(slave, tpdo_communication, frame).has_value();
}

/// Makes the slave answer a remote frame although bit 30 of the COB-ID forbids it.
void answer_forbidden(WrongSlave& slave, const Frame& frame) {
    const auto number = pdo_of(slave, tpdo_communication, frame);
    const bool forbidden = number && (pdo_parameter(slave, tpdo_communication, *number, 1) & 0x40000000U) != 0;
    if (frame.remote && forbidden && slave.state() == NmtState::operational) {
        slave.say(tpdo_frame(slave, *number));
    } else {
        slave.pass(frame);
    }
}

/// Makes the slave send no TPDO at the NMT command start. notes[0] is the time of this command.
Distortion starts_silently() {
    const auto hear = [](WrongSlave& slave, const Frame& frame) {
        if (is_data(frame, 0) && frame.data[0] == 1) {
            slave.notes[0] = static_cast<std::uint32_t>(slave.now().us);
        }
        slave.pass(frame);
    };
    Distortion both = keeps_back([](WrongSlave& slave, const Frame& frame) {
        return is_tpdo(slave, frame) && slave.notes[0] == static_cast<std::uint32_t>(slave.now().us);
    });
    both.hear = hear;
    return both;
}

Distortion sends_otherwise(FrameChange change) {
    return says([change = std::move(change)](WrongSlave& slave, const Frame& frame) {
        slave.say(is_tpdo(slave, frame) ? change(slave, frame) : frame);
    });
}

Frame with_high_byte_first(WrongSlave&, const Frame& frame) {
    Frame swapped = frame;
    for (std::size_t at = 0; at + 1 < frame.length; at += 2) {
        swapped.data.at(at) = frame.data.at(at + 1);
        swapped.data.at(at + 1) = frame.data.at(at);
    }
    return swapped;
}

Frame of_eight_bytes(WrongSlave&, const Frame& frame) {
    return with_length(frame, 8);
}

void say_twice(WrongSlave& slave, const Frame& frame) {
    slave.say(frame);
    if (is_tpdo(slave, frame)) {
        slave.say(frame);
    }
}

ObjectTest parameter(std::uint8_t subindex) {
    return entries(tpdo_communication, tpdo_communication + pdo_count - 1, subindex);
}

}  // namespace

Faults transmit_pdo_parameter_faults() {
    const std::string off = "605#2300180185010080 ";  // 1800h:01, bit 31
    return {
        {"tpdo-identifier-locked", "pdo", "confirms another identifier while the TPDO is valid", "605#2300180186010000",
         "585#8000180122000008", "585#6000180100000000", confirms_refused(parameter(1), 0x08000022)},
        {"tpdo-identifier-restricted", "pdo", "confirms a restricted identifier", off + "605#2300180101060000",
         "585#8000180130000906", "585#6000180100000000", confirms_refused(parameter(1), 0x06090030)},
        {"tpdo-type-reserved", "pdo", "confirms a reserved transmission type", off + "605#2F001802F1000000",
         "585#8000180230000906", "585#6000180200000000", confirms_refused(parameter(2), 0x06090030)},
        {"tpdo-inhibit-locked", "pdo", "confirms an inhibit time while the TPDO is valid", "605#2B00180364000000",
         "585#8000180322000008", "585#6000180300000000", confirms_refused(parameter(3), 0x08000022)},
    };
}

Faults transmit_pdo_faults() {
    const std::string off = "605#2300180185010080 ";  // 1800h:01, bit 31
    const std::string on = "605#2300180185010000 ";
    const std::string start = "000#0105 ";
    const std::string event = "605#2F01200107000000 ";  // 2001h:1 = 7, mapped into TPDO1
    const std::string word = "605#2B01210134120000 ";   // 2101h:1 = 1234h, mapped into TPDO2
    return {
        {"tpdo-pre-operational", "pdo", "sends TPDOs in Pre-operational", "080#", "", "185#0000 285#0000000000000000",
         sends_in(NmtState::pre_operational)},
        {"tpdo-stopped", "pdo", "sends TPDOs in Stopped", "000#0205 080#", "", "185#0000 285#0000000000000000",
         sends_in(NmtState::stopped)},
        {"tpdo-invalid-sent", "pdo", "sends a TPDO whose COB-ID is not valid", off + start + "080#", "",
         "185#0000 385# 485#", hears(send_invalid)},
        {"tpdo-start-silent", "pdo", "sends no TPDO when it enters Operational", start, "185#0000", "",
         starts_silently()},
        {"tpdo-inhibit-ignored", "pdo", "ignores the inhibit time",
         off + "605#2B001803E8030000 " + on + start + event + "+100", "100:185#0700", "185#0700",
         works_with(parameter(3), always(0))},
        {"tpdo-inhibit-short", "pdo", "keeps half the inhibit time",
         off + "605#2B001803E8030000 " + on + start + event + "+100", "100:185#0700", "50:185#0700",
         works_with(parameter(3), percent(50))},
        {"tpdo-timer-short", "pdo", "has an event timer that is 10 % short", "605#2B00180564000000 " + start + "+110",
         "100:185#0000", "90:185#0000", works_with(parameter(5), percent(90))},
        {"tpdo-timer-missing", "pdo", "has no event timer", "605#2B00180564000000 " + start + "+110", "100:185#0000",
         "", works_with(parameter(5), always(0))},
        {"tpdo-type-0", "pdo", "sends a TPDO of type 0 at SYNC without an event",
         "605#2F01180200000000 " + start + "080#", "", "285#0000000000000000",
         works_with(parameter(2), [](std::uint32_t value) { return (value & 0xFFU) == 0 ? 1U : value; })},
        {"tpdo-type-n", "pdo", "sends a TPDO of type 2 to 240 one SYNC too early",
         "605#2F01180203000000 " + start + "080# 080#", "", "285#0000000000000000",
         works_with(
             parameter(2),
             [](std::uint32_t value) { return value >= 2 && value <= last_synchronous_type ? value - 1 : value; })},
        {"tpdo-sync-start", "pdo", "ignores the SYNC start value",
         "605#2F19100004000000 605#2301180185020080 605#2F01180602000000 605#2301180185020000 " + start + "080#01", "",
         "285#0000000000000000", works_with(parameter(6), always(0))},
        {"tpdo-sync-twice", "pdo", "sends each TPDO twice", start + "080#", "", "185#0000 285#0000000000000000",
         says(say_twice)},
        {"tpdo-remote-ignored", "pdo", "does not answer remote frames", start + "185#R2", "185#0000", "",
         is_deaf_to(is_tpdo_request)},
        {"tpdo-remote-forbidden", "pdo", "answers remote frames that bit 30 forbids",
         off + "605#2300180185010040 " + start + "185#R2", "", "185#0000", hears(answer_forbidden)},
        {"tpdo-high-byte-first", "pdo", "sends the high byte of a word first", word + start + "080#",
         "285#3412000000000000", "285#1234000000000000", sends_otherwise(with_high_byte_first)},
        {"tpdo-length", "pdo", "sends eight bytes whatever is mapped", start, "185#0000", "185#0000000000000000",
         sends_otherwise(of_eight_bytes)},
    };
}

}  // namespace canproof::test::zoo
