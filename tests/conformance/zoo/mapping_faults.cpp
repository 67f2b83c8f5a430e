// SPDX-License-Identifier: Apache-2.0
// Faults of the PDO mapping and of changes of the mapping.
#include "tests/conformance/zoo/distortions.hpp"
#include "tests/conformance/zoo/faults.hpp"
#include "tests/conformance/zoo/pdo_frames.hpp"

namespace canproof::test::zoo {

namespace {

bool is_mapping(std::uint16_t index) {
    const bool received = index >= 0x1600 && index < 0x1600 + pdo_count;
    return received || (index >= 0x1A00 && index < 0x1A00 + pdo_count);
}
bool is_mapping_entry(std::uint16_t index, std::uint8_t) {
    return is_mapping(index);
}
bool is_line(std::uint16_t index, std::uint8_t sub) {
    return is_mapping(index) && sub != 0;
}
bool is_count(std::uint16_t index, std::uint8_t sub) {
    return is_mapping(index) && sub == 0;
}

/// Makes the slave confirm a mapping change that a correct slave refuses: a change of a valid PDO, or of one whose
/// mapping count (sub-index 0) is not 0.
Distortion confirms_locked(bool of_valid) {
    return answers_otherwise([of_valid](WrongSlave& slave, const Frame& frame) {
        const std::uint16_t index = index_of(frame);
        const bool refused = is_abort(frame, 0x08000022) && is_mapping(index);
        const auto communication = static_cast<std::uint16_t>(index - mapping_offset);
        const bool valid = (slave.dictionary().read(communication, 1) & 0x80000000U) == 0;
        return refused && valid == of_valid ? confirmation(slave.node_id(), frame) : frame;
    });
}

/// Makes the slave confirm writes of mapping entries but keep the old entries.
void keep_lines(WrongSlave& slave, const Frame& frame) {
    const bool writes =
        is_sdo_request(slave, frame) && is_expedited_download(frame) && is_line(index_of(frame), sub_of(frame));
    if (writes) {
        slave.say(confirmation(slave.node_id(), frame));
    } else {
        slave.pass(frame);
    }
}

void refuse_dummies(WrongSlave& slave, const Frame& frame) {
    const bool writes =
        is_sdo_request(slave, frame) && is_expedited_download(frame) && is_line(index_of(frame), sub_of(frame));
    if (writes && value_of(frame) != 0 && (value_of(frame) >> 16U) <= 7) {
        slave.say(abort_of(slave.node_id(), frame, 0x06040041));
    } else {
        slave.pass(frame);
    }
}

Distortion packs(Packing packing) {
    return says([packing](WrongSlave& slave, const Frame& frame) {
        const auto number = frame.remote ? std::nullopt : pdo_of(slave, tpdo_communication, frame);
        slave.say(number ? tpdo_frame(slave, *number, packing) : frame);
    });
}

/// After a change of the mapping, makes the slave send the first TPDO with the data of the previous mapping.
/// WrongSlave::bytes contains these data.
Distortion sends_stale_data() {
    const auto hear = [](WrongSlave& slave, const Frame& frame) {
        const bool maps =
            is_sdo_request(slave, frame) && is_expedited_download(frame) && is_line(index_of(frame), sub_of(frame));
        slave.notes[0] = maps ? 1 : slave.notes[0];
        slave.pass(frame);
    };
    const auto say = [](WrongSlave& slave, const Frame& frame) {
        if (frame.remote || !pdo_of(slave, tpdo_communication, frame)) {
            slave.say(frame);
            return;
        }
        Frame other = frame;
        slave.bytes.resize(8);
        for (std::size_t at = 0; at < 8; ++at) {
            other.data[at] = slave.notes[0] != 0 && at < frame.length ? slave.bytes[at] : frame.data[at];
            slave.bytes[at] = frame.data[at];
        }
        slave.notes[0] = 0;
        slave.say(other);
    };
    return hears_and_says(hear, say);
}

}  // namespace

Faults mapping_faults() {
    const std::string off = "605#2300180185010080 ";  // 1800h:01, bit 31
    const std::string on = "605#2300180185010000 ";
    const std::string none = "605#2F001A0000000000 ";  // 1A00h:00 = 0
    const std::string one = "605#2F001A0001000000 ";
    const std::string byte_3 = "605#23001A0108030120 ";  // 1A00h:01 = 2001h:03, 8 bits
    const std::string value_3 = "605#2F01200309000000 ";
    return {
        {"mapping-valid", "pdo", "confirms a change of the mapping of a valid PDO", none, "585#80001A0022000008",
         "585#60001A0000000000", confirms_locked(true)},
        {"mapping-count-set", "pdo", "confirms a line of the mapping while its count is not 0", off + byte_3,
         "585#80001A0122000008", "585#60001A0100000000", confirms_locked(false)},
        {"mapping-count-too-high", "pdo", "confirms a count above the lines of the mapping",
         off + "605#2F001A0009000000", "585#80001A0031000906", "585#60001A0000000000",
         confirms_refused(is_count, 0x06090031)},
        {"mapping-no-object", "pdo", "confirms a line that names no object", off + none + "605#23001A0108000050",
         "585#80001A0100000206", "585#60001A0100000000", confirms_refused(is_line, 0x06020000)},
        {"mapping-not-mappable", "pdo", "confirms an object that may not be mapped",
         off + none + "605#23001A0120000010", "585#80001A0141000406", "585#60001A0100000000",
         confirms_refused(is_line, 0x06040041)},
        {"mapping-65-bits", "pdo", "confirms a mapping of more than 64 bits",
         off + none + "605#23001A0140000622 605#23001A0208010120 605#2F001A0002000000", "585#80001A0042000406",
         "585#60001A0000000000", confirms_refused(is_mapping_entry, 0x06040042)},
        {"mapping-lost", "pdo", "confirms lines and keeps the old ones",
         off + none + byte_3 + one + on + value_3 + "000#0105", "185#09", "185#00", hears(keep_lines)},
        {"mapping-stale", "pdo", "sends old data in the first TPDO after a change of the mapping",
         "605#2F01200107000000 000#0105 000#8005 " + off + none + byte_3 + one + on + value_3 + "000#0105", "185#09",
         "185#07", sends_stale_data()},
        {"mapping-reversed", "pdo", "sends the mapped objects in reverse order", "605#2F01200107000000 000#0105",
         "185#0700", "185#0007", packs(Packing::reversed)},
        {"mapping-bits", "pdo", "sends each bit in a byte of its own",
         off + none + "605#23001A0101010320 605#23001A0201020320 605#2F001A0002000000 605#2F03200201000000 " + on +
             "000#0105",
         "185#02", "185#0001", packs(Packing::bytewise)},
        {"mapping-dummy", "pdo", "refuses a dummy object in an RPDO",
         "605#2300140105020080 605#2F00160000000000 605#2300160108000500", "585#6000160100000000",
         "585#8000160141000406", hears(refuse_dummies)},
    };
}

}  // namespace canproof::test::zoo
