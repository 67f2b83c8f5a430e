// SPDX-License-Identifier: Apache-2.0
// Decodes SDO frames (CiA 301, 7.2.4.3). Each frame is decoded by itself, so the object to which a segment belongs is
// not known.
#include <fmt/format.h>

#include "firmware/canopen/sdo_protocol.hpp"
#include "host/sim/decode/decode_frame.hpp"
#include "host/sim/decode/object_words.hpp"

namespace canproof::host {

namespace {

constexpr std::size_t sdo_length = 8U;
constexpr std::uint8_t command_mask = 0xE0U;

std::string object_of(ByteView data, const Part* part) {
    return entry_words(part, static_cast<std::uint16_t>(read_le(data, sdo::index_position, 2U)),
                       data[sdo::subindex_position]);
}

/// Returns the value of an expedited transfer as text. If the command byte contains no length, the value has all four
/// bytes.
std::string expedited_value(ByteView data, const Part* part) {
    const bool sized = (data[0] & sdo::size_flag) != 0U;
    const std::size_t unused = sized ? (data[0] >> 2U) & 3U : 0U;
    const Entry* const entry = entry_at(part, static_cast<std::uint16_t>(read_le(data, sdo::index_position, 2U)),
                                        data[sdo::subindex_position]);
    return value_words(entry, data.part(sdo::data_position, sdo::expedited_capacity - unused));
}

std::string announced_length(ByteView data) {
    const bool sized = (data[0] & sdo::size_flag) != 0U;
    return sized ? fmt::format(", {} bytes in segments", read_le(data, sdo::data_position, 4U)) : ", in segments";
}

std::string segment(ByteView data) {
    const std::size_t count = sdo::segment_capacity - ((data[0] >> 1U) & 7U);
    const bool last = (data[0] & sdo::last_segment_flag) != 0U;
    return fmt::format("{}segment: {}", last ? "last " : "", value_words(nullptr, data.part(1U, count)));
}

}  // namespace

std::string FrameDecoder::abort_words(ByteView data, const Part* part) const {
    const std::uint64_t code = read_le(data, sdo::data_position, 4U);
    const std::string why = word(nullptr, "AbortCode", code);
    return fmt::format("abort {}: {:08X}h {}", object_of(data, part), code, why.empty() ? "unknown reason" : why);
}

std::string FrameDecoder::sdo_request(ByteView data, const Part* part) const {
    if (data.size() != sdo_length) {
        return "malformed: eight bytes are needed";
    }
    const bool expedited = (data[0] & sdo::expedited_flag) != 0U;
    switch (static_cast<sdo::ClientCommand>(data[0] >> 5U)) {
        case sdo::ClientCommand::download_segment:
            return "write " + segment(data);
        case sdo::ClientCommand::initiate_download:
            return "write " + object_of(data, part) +
                   (expedited ? " = " + expedited_value(data, part) : announced_length(data));
        case sdo::ClientCommand::initiate_upload:
            return "read " + object_of(data, part);
        case sdo::ClientCommand::upload_segment:
            return "read next segment";
        case sdo::ClientCommand::abort:
            return abort_words(data, part);
        case sdo::ClientCommand::block_upload:
            return (data[0] & 3U) == 0U ? "read " + object_of(data, part) + " in blocks" : "read blocks";
        case sdo::ClientCommand::block_download:
            return (data[0] & sdo::block_end_flag) == 0U ? "write " + object_of(data, part) + " in blocks"
                                                         : "end of blocks";
        case sdo::ClientCommand::unassigned:
        default:
            return "unknown command " + value_words(nullptr, data);
    }
}

std::string FrameDecoder::sdo_answer(ByteView data, const Part* part) const {
    if (data.size() != sdo_length) {
        return "malformed: eight bytes are needed";
    }
    const bool expedited = (data[0] & sdo::expedited_flag) != 0U;
    switch (data[0] & command_mask) {
        case 0x00U:
            return "answers " + segment(data);
        case sdo::download_segment_done:
            return "segment taken";
        case sdo::upload_initiated:
            return "answers " + object_of(data, part) +
                   (expedited ? " = " + expedited_value(data, part) : announced_length(data));
        case sdo::download_done:
            return "has written " + object_of(data, part);
        case sdo::aborted:
            return abort_words(data, part);
        case sdo::block_download_initiated:
            return "takes blocks";
        case sdo::block_upload_initiated:
            return (data[0] & sdo::block_end_flag) == 0U ? "answers " + object_of(data, part) + " in blocks"
                                                         : "end of blocks";
        default:
            return "unknown answer " + value_words(nullptr, data);
    }
}

}  // namespace canproof::host
