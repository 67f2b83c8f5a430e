// SPDX-License-Identifier: Apache-2.0
// Faults of the SDO server: it accepts requests that a correct slave refuses, or refuses requests that a correct slave
// accepts.
#include "tests/conformance/zoo/distortions.hpp"
#include "tests/conformance/zoo/faults.hpp"

namespace canproof::test::zoo {

namespace {

/// Returns an expedited download with its length changed to that of the entry.
Frame as_long_as_entry(WrongSlave& slave, const Frame& frame) {
    const EntryRef entry = slave.dictionary().lookup(index_of(frame), sub_of(frame));
    if (!is_expedited_download(frame) || !entry.exists() || entry.row->size > 4) {
        return frame;
    }
    return with_command(frame, 0x23U | ((4U - entry.row->size) << 2U));
}

Distortion takes_length(bool too_long) {
    return takes_requests_as([too_long](WrongSlave& slave, const Frame& frame) {
        const Frame fitted = as_long_as_entry(slave, frame);
        const bool longer = expedited_size(frame) > expedited_size(fitted);
        return is_expedited_download(frame) && longer == too_long ? fitted : frame;
    });
}

void without_upper_limits(host::Part& part) {
    for (host::Object& object : part.objects) {
        for (host::Entry& entry : object.entries) {
            entry.range.maximum = {};
        }
    }
}

void without_lower_limits(host::Part& part) {
    for (host::Object& object : part.objects) {
        for (host::Entry& entry : object.entries) {
            entry.range.minimum = {};
        }
    }
}

/// Makes the slave answer an upload request for a write-only entry with the value of the entry.
void read_write_only(WrongSlave& slave, const Frame& frame) {
    if (!is_sdo_answer(slave, frame) || !is_abort(frame, 0x06010001)) {
        slave.say(frame);
        return;
    }
    const std::uint32_t value = slave.dictionary().read(index_of(frame), sub_of(frame));
    slave.say(with_value(with_command(frame, 0x43), value));
}

}  // namespace

Faults sdo_faults() {
    return {
        {"sdo-abort-no-object", "sdo", "names a missing sub-index where the object is missing", "605#4004100000000000",
         "585#8004100000000206", "585#8004100011000906", aborts_with(0x06020000, 0x06090011)},
        {"sdo-abort-no-subindex", "sdo", "names a missing object where the sub-index is missing",
         "605#4000100100000000", "585#8000100111000906", "585#8000100100000206", aborts_with(0x06090011, 0x06020000)},
        {"sdo-abort-read-only", "sdo", "refuses a write to a constant object with the code of a missing object",
         "605#2300100000000000", "585#8000100002000106", "585#8000100000000206", aborts_with(0x06010002, 0x06020000)},
        {"sdo-read-only-confirmed", "sdo", "confirms a write to a constant object", "605#2300100000000000",
         "585#8000100002000106", "585#6000100000000000", confirms_refused(objects(0x1000, 0xFFFF), 0x06010002)},
        {"sdo-write-only-read", "sdo", "lets a write-only entry be read", "605#4005220000000000",
         "585#8005220001000106", "585#4305220000000000", says(read_write_only)},
        {"sdo-too-long-taken", "sdo", "takes the first bytes of a download that is too long", "605#2317100000000000",
         "585#8017100012000706", "585#6017100000000000", takes_length(true)},
        {"sdo-too-short-taken", "sdo", "takes a download that is too short", "605#2F05100080000000",
         "585#8005100013000706", "585#6005100000000000", takes_length(false)},
        {"sdo-upper-limit-ignored", "sdo", "takes values above the upper limit", "605#2B00220065000000",
         "585#8000220031000906", "585#6000220000000000", has_dictionary(without_upper_limits)},
        {"sdo-lower-limit-ignored", "sdo", "takes values below the lower limit", "605#2B0022009BFF0000",
         "585#8000220032000906", "585#6000220000000000", has_dictionary(without_lower_limits)},
        {"sdo-limit-code", "sdo", "refuses a value that is too high with 06040043h", "605#2B00220065000000",
         "585#8000220031000906", "585#8000220043000406", aborts_with(0x06090031, 0x06040043)},
    };
}

}  // namespace canproof::test::zoo
