// SPDX-License-Identifier: Apache-2.0
// Faults of receive PDOs: when they are applied, and to which objects.
#include "tests/conformance/zoo/distortions.hpp"
#include "tests/conformance/zoo/faults.hpp"
#include "tests/conformance/zoo/pdo_frames.hpp"

namespace canproof::test::zoo {

namespace {

/// Returns the number of the RPDO to which `frame` belongs, or nothing.
std::optional<unsigned> rpdo_of(WrongSlave& slave, const Frame& frame, bool valid = true) {
    return frame.remote ? std::nullopt : pdo_of(slave, rpdo_communication, frame, valid);
}

bool is_too_short(WrongSlave& slave, const Frame& frame) {
    const auto number = rpdo_of(slave, frame);
    return number && frame.length < rpdo_length(slave, *number);
}

bool is_too_long(WrongSlave& slave, const Frame& frame) {
    const auto number = rpdo_of(slave, frame);
    return number && frame.length > rpdo_length(slave, *number);
}

void complete_short(WrongSlave& slave, const Frame& frame) {
    slave.pass(is_too_short(slave, frame) ? with_length(frame, 8) : frame);
}

/// Makes the slave apply RPDOs in `state`, in which a correct slave applies none.
Distortion applies_in(NmtState state) {
    return hears([state](WrongSlave& slave, const Frame& frame) {
        const auto number = rpdo_of(slave, frame);
        if (number && slave.state() == state) {
            apply_rpdo(slave, *number, frame);
        }
        slave.pass(frame);
    });
}

void apply_invalid(WrongSlave& slave, const Frame& frame) {
    const auto number = rpdo_of(slave, frame, false);
    if (number && slave.state() == NmtState::operational) {
        apply_rpdo(slave, *number, frame);
    }
    slave.pass(frame);
}

void obey_extended(WrongSlave& slave, const Frame& frame) {
    Frame standard = frame;
    standard.extended = false;
    slave.pass(rpdo_of(slave, standard) ? standard : frame);
}

void take_high_byte_first(WrongSlave& slave, const Frame& frame) {
    Frame swapped = frame;
    for (std::size_t at = 0; rpdo_of(slave, frame) && at + 1 < frame.length; at += 2) {
        swapped.data.at(at) = frame.data.at(at + 1);
        swapped.data.at(at + 1) = frame.data.at(at);
    }
    slave.pass(swapped);
}

/// If a synchronous RPDO is received several times between two SYNCs, makes the slave apply the first one instead of
/// the last.
void keep_first(WrongSlave& slave, const Frame& frame) {
    const auto number = rpdo_of(slave, frame);
    const bool waits = number && pdo_parameter(slave, rpdo_communication, *number, 2) <= 240;
    if (is_data(frame, slave.dictionary().read(0x1005, 0) & 0x7FFU)) {
        slave.notes.clear();
    }
    if (!waits || slave.notes[*number]++ == 0) {
        slave.pass(frame);
    }
}

/// Makes the slave start the event timers of RPDOs at the NMT command start. A correct slave starts each timer with the
/// first reception of the RPDO.
void watch_from_start(WrongSlave& slave, const Frame& frame) {
    slave.pass(frame);
    if (!is_data(frame, 0) || slave.state() != NmtState::operational) {
        return;
    }
    for (unsigned number = 0; number < pdo_count; ++number) {
        const std::uint32_t cob_id = pdo_parameter(slave, rpdo_communication, number, 1);
        if (is_valid_pdo(slave, rpdo_communication, number) &&
            pdo_parameter(slave, rpdo_communication, number, 5) != 0) {
            slave.pass(data_frame(cob_id & 0x7FFU, 8));
        }
    }
}

ObjectTest parameter(std::uint8_t subindex) {
    return entries(rpdo_communication, rpdo_communication + pdo_count - 1, subindex);
}

}  // namespace

Faults receive_pdo_faults() {
    const std::string start = "000#0105 ";
    const std::string synchronous = "605#2F00140201000000 ";  // 1400h:2 transmission type of RPDO1: 1
    const std::string read = "605#4000200100000000";          // 2000h:01, mapped into RPDO 1 with 2000h:02
    const std::string still_0 = "585#4F00200100000000";
    const std::string now_7 = "585#4F00200107000000";
    return {
        {"rpdo-at-once", "pdo", "applies a synchronous RPDO at once", synchronous + start + "205#0702 " + read, still_0,
         now_7, works_with(parameter(2), [](std::uint32_t value) { return value <= 240 ? 255U : value; })},
        {"rpdo-at-sync", "pdo", "applies an RPDO of type 254 or 255 at the next SYNC",
         "605#2F001402FE000000 " + start + "205#0702 " + read, now_7, still_0,
         works_with(parameter(2), [](std::uint32_t value) { return value >= 254 ? 1U : value; })},
        {"rpdo-first-counts", "pdo", "keeps the first RPDO before a SYNC, not the last",
         synchronous + start + "205#0102 205#0702 080# " + read, now_7, "585#4F00200101000000", hears(keep_first)},
        {"rpdo-short-applied", "pdo", "applies an RPDO that is too short", start + "205#07 " + read,
         "085#1082110100000000 " + still_0, now_7, hears(complete_short)},
        {"rpdo-long-ignored", "pdo", "ignores an RPDO that is longer than mapped", start + "205#070809 " + read, now_7,
         still_0, is_deaf_to(is_too_long)},
        {"rpdo-pre-operational", "pdo", "applies RPDOs in Pre-operational", "205#0702 " + read, still_0, now_7,
         applies_in(NmtState::pre_operational)},
        {"rpdo-stopped", "pdo", "applies RPDOs in Stopped", "000#0205 205#0702 000#8005 " + read, still_0, now_7,
         applies_in(NmtState::stopped)},
        {"rpdo-invalid-applied", "pdo", "applies an RPDO whose COB-ID is not valid",
         "605#2300140105020080 " + start + "205#0702 " + read, still_0, now_7, hears(apply_invalid)},
        {"rpdo-extended-applied", "pdo", "applies RPDOs with a 29-bit identifier", start + "00000205#0702 " + read,
         still_0, now_7, hears(obey_extended)},
        {"rpdo-high-byte-first", "pdo", "takes the high byte of a word first",
         start + "305#3412000000000000 605#4000210100000000", "585#4B00210134120000", "585#4B00210112340000",
         hears(take_high_byte_first)},
        {"rpdo-timer-ignored", "pdo", "does not notice that an RPDO is overdue",
         "605#2B00140564000000 " + start + "205#0702 +100", "100:085#5082110100000000", "",
         works_with(parameter(5), always(0))},
        {"rpdo-timer-from-start", "pdo", "watches an RPDO that has not come yet",
         "605#2B00140564000000 " + start + "+100", "", "100:085#5082110100000000", hears(watch_from_start)},
    };
}

}  // namespace canproof::test::zoo
