// SPDX-License-Identifier: Apache-2.0
// Faults of segmented SDO transfers.
#include "tests/conformance/zoo/distortions.hpp"
#include "tests/conformance/zoo/faults.hpp"

namespace canproof::test::zoo {

namespace {

constexpr unsigned segment_answer = 0;    // command specifier of an upload segment, sent by the server
constexpr unsigned segment_taken = 1;     // command specifier of the server's answer to a download segment
constexpr unsigned upload_segment = 3;    // command specifier of the client's request for an upload segment
constexpr unsigned download_segment = 0;  // command specifier of a download segment, sent by the client
constexpr unsigned toggle = 0x10;

Distortion sticks_at_toggle(unsigned specifier) {
    return answers_otherwise([specifier](WrongSlave&, const Frame& frame) {
        return specifier_of(frame) == specifier ? with_command(frame, command_of(frame) & ~toggle) : frame;
    });
}

/// Serves segments whose toggle bit is wrong, and answers with this toggle bit.
Distortion takes_any_toggle(unsigned request, unsigned answer) {
    const auto hear = [request](WrongSlave& slave, const Frame& frame) {
        if (!is_sdo_request(slave, frame) || specifier_of(frame) != request) {
            slave.notes[0] = 0;
            slave.pass(frame);
            return;
        }
        slave.notes[1] = command_of(frame) & toggle;
        slave.pass(with_command(frame, (command_of(frame) & ~toggle) | slave.notes[0]));
        slave.notes[0] ^= toggle;
    };
    const auto say = [answer](WrongSlave& slave, const Frame& frame) {
        const bool is_segment = is_sdo_answer(slave, frame) && specifier_of(frame) == answer;
        slave.say(is_segment ? with_command(frame, (command_of(frame) & ~toggle) | slave.notes[1]) : frame);
    };
    return hears_and_says(hear, say);
}

Frame with_size_plus_one(WrongSlave&, const Frame& frame) {
    return command_of(frame) == 0x41 ? with_value(frame, value_of(frame) + 1) : frame;
}

/// Makes the slave clear the bits of `bits` in the command byte of upload segments.
Distortion clears_in_segment(unsigned bits) {
    return answers_otherwise([bits](WrongSlave&, const Frame& frame) {
        return specifier_of(frame) == segment_answer ? with_command(frame, command_of(frame) & ~bits) : frame;
    });
}

/// Drops the size that a segmented download announces.
Frame without_announced_size(WrongSlave&, const Frame& frame) {
    return command_of(frame) == 0x21 ? with_command(frame, 0x20) : frame;
}

void put_gathered(WrongSlave& slave) {
    const auto index = static_cast<std::uint16_t>(slave.notes[0]);
    const EntryRef entry = slave.dictionary().lookup(index, static_cast<std::uint8_t>(slave.notes[1]));
    const bool fits = entry.exists() && entry.row->type != DataType::domain && slave.bytes.size() <= entry.row->size;
    if (fits && !slave.bytes.empty() && has_variable_length(entry.row->type)) {
        static_cast<void>(slave.dictionary().put(entry, ByteView{slave.bytes.data(), slave.bytes.size()}));
    }
}

/// When the client aborts the download of a string, makes the slave store the bytes received until then.
void keep_aborted(WrongSlave& slave, const Frame& frame) {
    if (is_sdo_request(slave, frame) && (command_of(frame) & 0xE2U) == 0x20) {
        slave.notes[0] = index_of(frame);
        slave.notes[1] = sub_of(frame);
        slave.bytes.clear();
    } else if (is_sdo_request(slave, frame) && specifier_of(frame) == download_segment) {
        const std::size_t count = 7U - ((command_of(frame) >> 1U) & 7U);
        slave.bytes.insert(slave.bytes.end(), frame.data.begin() + 1,
                           frame.data.begin() + 1 + static_cast<std::ptrdiff_t>(count));
    } else if (is_sdo_request(slave, frame) && is_abort(frame)) {
        put_gathered(slave);
    }
    slave.pass(frame);
}

/// Makes the slave refuse an initiate request during a transfer. notes[0] is not 0 while a segmented upload is open.
Distortion refuses_initiate_inside() {
    const auto hear = [](WrongSlave& slave, const Frame& frame) {
        const bool initiates = is_sdo_request(slave, frame) && (specifier_of(frame) == 1 || specifier_of(frame) == 2);
        if (initiates && slave.notes[0] != 0) {
            slave.notes[0] = 0;
            slave.pass(with_command(frame, 0x80));
            slave.say(abort_of(slave.node_id(), frame, 0x05040001));
        } else {
            slave.pass(frame);
        }
    };
    const auto say = [](WrongSlave& slave, const Frame& frame) {
        if (is_sdo_answer(slave, frame)) {
            const bool goes_on = specifier_of(frame) == segment_answer && (command_of(frame) & 1U) == 0;
            slave.notes[0] = (command_of(frame) & 0xE2U) == 0x40 || goes_on ? 1 : 0;
        }
        slave.say(frame);
    };
    return hears_and_says(hear, say);
}

bool is_last_confirmation(WrongSlave& slave, const Frame& frame) {
    return is_sdo_answer(slave, frame) && specifier_of(frame) == segment_taken && slave.notes[0] != 0;
}

Distortion confirms_no_last_segment() {
    const auto hear = [](WrongSlave& slave, const Frame& frame) {
        slave.notes[0] = specifier_of(frame) == download_segment ? command_of(frame) & 1U : 0;
        slave.pass(frame);
    };
    Distortion both = keeps_back(is_last_confirmation);
    both.hear = hear;
    return both;
}

}  // namespace

Faults sdo_transfer_faults() {
    const std::string upload = "605#4008100000000000";        // 1008h, "Conformance slave"
    const std::string download = "605#210023000E000000 ";     // 2300h, announced: 14 bytes
    const std::string first_seven = "605#0041424344454647 ";  // toggle 0
    return {
        {"sdo-upload-toggle-stuck", "sdo", "does not alternate the toggle of upload segments",
         upload + " 605#6000000000000000 605#7000000000000000", "585#10616E636520736C", "585#00616E636520736C",
         sticks_at_toggle(segment_answer)},
        {"sdo-download-toggle-stuck", "sdo", "does not alternate the toggle of its answers to download segments",
         download + first_seven + "605#1141424344454647", "585#3000000000000000", "585#2000000000000000",
         sticks_at_toggle(segment_taken)},
        {"sdo-upload-toggle-unchecked", "sdo", "serves a wrong toggle in an upload", upload + " 605#7000000000000000",
         "585#8008100000000305", "585#10436F6E666F726D", takes_any_toggle(upload_segment, segment_answer)},
        {"sdo-download-toggle-unchecked", "sdo", "serves a wrong toggle in a download",
         download + "605#1041424344454647", "585#8000230000000305", "585#3000000000000000",
         takes_any_toggle(download_segment, segment_taken)},
        {"sdo-toggle-code", "sdo", "refuses a wrong toggle with 06090030h", upload + " 605#7000000000000000",
         "585#8008100000000305", "585#8008100030000906", aborts_with(0x05030000, 0x06090030)},
        {"sdo-upload-size", "sdo", "announces one byte more than it uploads", upload, "585#4108100011000000",
         "585#4108100012000000", answers_otherwise(with_size_plus_one)},
        {"sdo-upload-no-end", "sdo", "does not mark the last segment of an upload",
         upload + " 605#6000000000000000 605#7000000000000000 605#6000000000000000", "585#0961766500000000",
         "585#0861766500000000", clears_in_segment(0x01)},
        {"sdo-upload-unused", "sdo", "does not show the unused bytes of the last segment",
         upload + " 605#6000000000000000 605#7000000000000000 605#6000000000000000", "585#0961766500000000",
         "585#0161766500000000", clears_in_segment(0x0E)},
        {"sdo-download-size-unchecked", "sdo", "takes less segments than the download announced",
         download + "605#0941424300000000", "585#8000230010000706", "585#2000000000000000",
         takes_requests_as(without_announced_size)},
        {"sdo-aborted-download-kept", "sdo", "keeps what a download brought that the client aborts",
         download + first_seven + "605#8000230000000008 605#4000230000000000", "585#4700230061626300",
         "585#4100230007000000", hears(keep_aborted)},
        {"sdo-initiate-refused", "sdo", "refuses a request that begins inside an open upload",
         upload + " 605#4000100000000000", "585#4300100078563412", "585#8000100001000405", refuses_initiate_inside()},
        {"sdo-last-segment-silent", "sdo", "does not confirm the last segment of a download",
         download + first_seven + "605#1141424344454647", "585#3000000000000000", "", confirms_no_last_segment()},
    };
}

}  // namespace canproof::test::zoo
