// SPDX-License-Identifier: Apache-2.0
// Faults of SDO block transfer.
#include "firmware/base/crc16.hpp"
#include "tests/conformance/zoo/distortions.hpp"
#include "tests/conformance/zoo/faults.hpp"

namespace canproof::test::zoo {

namespace {

bool is_upload_initiate(const Frame& frame) {
    return specifier_of(frame) == 5 && (command_of(frame) & 3U) == 0;
}
bool is_upload_acknowledge(const Frame& frame) {
    return command_of(frame) == 0xA2;
}
bool is_upload_end(const Frame& frame) {
    return (command_of(frame) & 0xE3U) == 0xC1;
}
bool is_download_initiate(const Frame& frame) {
    return (command_of(frame) & 0xE1U) == 0xC0;
}

/// Makes the slave end a block upload with a wrong number of unused bytes or a wrong CRC.
Distortion ends_upload_otherwise(FrameChange change) {
    return answers_otherwise([change = std::move(change)](WrongSlave& slave, const Frame& frame) {
        return is_upload_end(frame) ? change(slave, frame) : frame;
    });
}

Frame with_crc(Frame frame, std::uint16_t crc) {
    set_field_le<1, 2>(frame.data, crc);
    return frame;
}

/// Makes the slave compute the CRC of an upload over whole segments, including the unused bytes of the last segment.
Distortion crc_over_padding() {
    const auto hear = [](WrongSlave& slave, const Frame& frame) {
        if (is_sdo_request(slave, frame) && is_upload_initiate(frame)) {
            slave.bytes.clear();
        }
        slave.pass(frame);
    };
    const auto say = [](WrongSlave& slave, const Frame& frame) {
        if (slave.says_segment()) {
            slave.bytes.insert(slave.bytes.end(), frame.data.begin() + 1, frame.data.end());
        }
        const bool ends = is_sdo_answer(slave, frame) && is_upload_end(frame);
        Crc16 crc;
        crc.add(ByteView{slave.bytes.data(), slave.bytes.size()});
        slave.say(ends ? with_crc(frame, crc.value()) : frame);
    };
    return hears_and_says(hear, say);
}

Frame without_crc_flag(WrongSlave&, const Frame& frame) {
    return is_download_initiate(frame) ? with_command(frame, command_of(frame) & ~4U) : frame;
}

/// Makes the slave use another block size than the client requests when it initiates a block upload.
Distortion takes_block_size(std::function<unsigned(unsigned)> change) {
    return takes_requests_as([change = std::move(change)](WrongSlave&, const Frame& frame) {
        return is_upload_initiate(frame) ? with_byte(frame, 4, change(frame.data[4])) : frame;
    });
}

/// Makes the slave keep the block size of the initiate request, although a later acknowledgement requests another size.
Frame with_first_block_size(WrongSlave& slave, const Frame& frame) {
    if (is_upload_initiate(frame)) {
        slave.notes[0] = frame.data[4];
    }
    return is_upload_acknowledge(frame) ? with_byte(frame, 2, slave.notes[0]) : frame;
}

/// Makes the slave never repeat segments that the client has not acknowledged: it continues with the next segment.
Distortion repeats_nothing() {
    const auto hear = [](WrongSlave& slave, const Frame& frame) {
        const bool acknowledges = is_sdo_request(slave, frame) && is_upload_acknowledge(frame) && frame.data[1] < 128;
        slave.pass(acknowledges ? with_byte(frame, 1, slave.notes[0]) : frame);
    };
    const auto say = [](WrongSlave& slave, const Frame& frame) {
        if (slave.says_segment()) {
            slave.notes[0] = command_of(frame) & 0x7FU;
        }
        slave.say(frame);
    };
    return hears_and_says(hear, say);
}

/// Makes the slave continue the segment numbers of an upload in the next block. A correct slave begins each block at 1.
Distortion counts_on() {
    const auto hear = [](WrongSlave& slave, const Frame& frame) {
        if (is_sdo_request(slave, frame) && command_of(frame) == 0xA3) {
            slave.notes[0] = 0;
        }
        slave.pass(frame);
    };
    const auto say = [](WrongSlave& slave, const Frame& frame) {
        if (!slave.says_segment()) {
            slave.say(frame);
            return;
        }
        slave.notes[0] = slave.notes[0] % 127 + 1;
        slave.say(with_command(frame, (command_of(frame) & 0x80U) | slave.notes[0]));
    };
    return hears_and_says(hear, say);
}

void say_without_last_mark(WrongSlave& slave, const Frame& frame) {
    slave.say(slave.says_segment() ? with_command(frame, command_of(frame) & 0x7FU) : frame);
}

/// Makes the slave acknowledge the newest segment of a download even when an earlier one was lost. notes[0] is the
/// number of the newest segment.
Distortion misses_no_segment() {
    const auto hear = [](WrongSlave& slave, const Frame& frame) {
        slave.notes[0] = command_of(frame) & 0x7FU;
        slave.pass(frame);
    };
    const auto say = [](WrongSlave& slave, const Frame& frame) {
        const bool acknowledges = is_sdo_answer(slave, frame) && command_of(frame) == 0xA2;
        slave.say(acknowledges ? with_byte(frame, 1, slave.notes[0]) : frame);
    };
    return hears_and_says(hear, say);
}

Frame with_server_block_size_0(WrongSlave&, const Frame& frame) {
    return command_of(frame) == 0xA4 ? with_byte(frame, 4, 0) : frame;
}

Frame with_size_plus_one(WrongSlave&, const Frame& frame) {
    return command_of(frame) == 0xC6 ? with_value(frame, value_of(frame) + 1) : frame;
}

Frame without_announced_size(WrongSlave&, const Frame& frame) {
    return is_download_initiate(frame) ? with_command(frame, command_of(frame) & ~2U) : frame;
}

bool is_download_end(WrongSlave& slave, const Frame& frame) {
    return is_sdo_answer(slave, frame) && command_of(frame) == 0xA1;
}

}  // namespace

Faults sdo_block_faults() {
    const auto upload = [](const std::string& block_size) {  // uploads 1008h, "Conformance slave": 17 bytes, CRC 32D4h
        return "605#A4081000" + block_size + "000000 605#A300000000000000 ";
    };
    const std::string end = "605#A203140000000000";
    // begins a download of 14 bytes to 2300h, with a CRC
    const std::string download = "605#C60023000E000000 605#0141424344454647 ";
    return {
        {"block-crc-padding", "sdo", "takes the CRC of an upload over the padding too", upload("14") + end,
         "585#D1D4320000000000", "585#D1D5780000000000", crc_over_padding()},
        {"block-crc-zero", "sdo", "sends CRC 0", upload("14") + end, "585#D1D4320000000000", "585#D100000000000000",
         ends_upload_otherwise([](WrongSlave&, const Frame& frame) { return with_crc(frame, 0); })},
        {"block-unused", "sdo", "does not show the unused bytes of the last segment", upload("14") + end,
         "585#D1D4320000000000", "585#C1D4320000000000",
         ends_upload_otherwise([](WrongSlave&, const Frame& frame) { return with_command(frame, 0xC1); })},
        {"block-size-ignored", "sdo", "sends more segments than the client's block size", upload("01"), "",
         "585#02616E636520736C 585#8361766500000000",
         takes_block_size([](unsigned size) { return size >= 1 && size <= 127 ? 127U : size; })},
        {"block-size-kept", "sdo", "keeps to the first block size of an upload", upload("01") + "605#A201020000000000",
         "585#8261766500000000", "", takes_requests_as(with_first_block_size)},
        {"block-size-128", "sdo", "takes 128 for a block size", "605#A008100080000000", "585#8008100002000405",
         "585#C608100011000000", takes_block_size([](unsigned size) { return size == 128 ? 127U : size; })},
        {"block-size-0", "sdo", "takes 0 for a block size", "605#A008100000000000", "585#8008100002000405",
         "585#C608100011000000", takes_block_size([](unsigned size) { return size == 0 ? 1U : size; })},
        {"block-sequence", "sdo", "counts the segments on from block to block", upload("01") + "605#A201010000000000",
         "585#01616E636520736C", "585#02616E636520736C", counts_on()},
        {"block-no-end", "sdo", "does not mark the last segment", upload("14"), "585#8361766500000000",
         "585#0361766500000000", says(say_without_last_mark)},
        {"block-repeats-nothing", "sdo", "does not repeat segments that the client missed",
         upload("14") + "605#A201140000000000", "585#01616E636520736C 585#8261766500000000", "585#D1D4320000000000",
         repeats_nothing()},
        {"block-upload-size", "sdo", "announces one byte more than it uploads", "605#A408100014000000",
         "585#C608100011000000", "585#C608100012000000", answers_otherwise(with_size_plus_one)},
        {"block-crc-unchecked", "sdo", "takes a download with a wrong CRC",
         download + "605#8241424344454647 605#C100000000000000", "585#8000230004000405", "585#A100000000000000",
         takes_requests_as(without_crc_flag)},
        {"block-loss-unnoticed", "sdo", "acknowledges a segment that it did not get", download + "605#8341424344454647",
         "585#A2017F0000000000", "585#A2037F0000000000", misses_no_segment()},
        {"block-server-size-0", "sdo", "asks for blocks of 0 segments", "605#C60023000E000000", "585#A40023007F000000",
         "585#A400230000000000", answers_otherwise(with_server_block_size_0)},
        {"block-download-size-unchecked", "sdo", "takes a download that is shorter than announced",
         "605#C20023000E000000 605#8141424344454647 605#C100000000000000", "585#8000230010000706",
         "585#A100000000000000", takes_requests_as(without_announced_size)},
        {"block-download-end-silent", "sdo", "does not confirm the end of a download",
         "605#C200230007000000 605#8141424344454647 605#C100000000000000", "585#A100000000000000", "",
         keeps_back(is_download_end)},
    };
}

}  // namespace canproof::test::zoo
