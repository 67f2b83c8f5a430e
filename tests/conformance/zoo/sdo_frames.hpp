// SPDX-License-Identifier: Apache-2.0
// Reads and builds the fields of SDO frames, for the faults of the SDO server.
#pragma once

#include "tests/conformance/zoo/wrong_slave.hpp"

namespace canproof::test::zoo {

constexpr std::uint32_t sdo_requests = 0x600;
constexpr std::uint32_t sdo_answers = 0x580;
constexpr std::uint32_t error_control = 0x700;

inline bool is_data(const Frame& frame, std::uint32_t id) {
    return frame.id == id && !frame.extended && !frame.remote;
}
inline bool is_boot_up(const Frame& frame, std::uint8_t node) {
    return is_data(frame, error_control + node) && frame.length == 1 && frame.data[0] == 0;
}
inline bool is_sdo_request(const WrongSlave& slave, const Frame& frame) {
    return is_data(frame, sdo_requests + slave.node_id()) && frame.length == 8;
}
/// Returns whether a frame is an answer of the SDO server, and no segment of a block upload.
inline bool is_sdo_answer(const WrongSlave& slave, const Frame& frame) {
    return is_data(frame, sdo_answers + slave.node_id()) && !slave.says_segment();
}

inline std::uint8_t command_of(const Frame& frame) {
    return frame.data[0];
}
/// Returns the upper three bits of the SDO command, the command specifier.
inline unsigned specifier_of(const Frame& frame) {
    return frame.data[0] >> 5U;
}
inline std::uint16_t index_of(const Frame& frame) {
    return static_cast<std::uint16_t>(field_le<1, 2>(frame.data));
}
inline std::uint8_t sub_of(const Frame& frame) {
    return frame.data[3];
}
inline std::uint32_t value_of(const Frame& frame) {
    return static_cast<std::uint32_t>(field_le<4, 4>(frame.data));
}

inline Frame with_command(Frame frame, unsigned command) {
    frame.data[0] = static_cast<std::uint8_t>(command);
    return frame;
}
inline Frame with_value(Frame frame, std::uint32_t value) {
    set_field_le<4, 4>(frame.data, value);
    return frame;
}
inline Frame with_byte(Frame frame, std::size_t at, unsigned byte) {
    frame.data.at(at) = static_cast<std::uint8_t>(byte);
    return frame;
}
inline Frame with_length(Frame frame, std::size_t length) {
    frame.length = static_cast<std::uint8_t>(length);
    return frame;
}
inline Frame with_id(Frame frame, std::uint32_t id) {
    frame.id = id;
    return frame;
}

inline bool is_expedited_download(const Frame& frame) {
    return (frame.data[0] & 0xE3U) == 0x23U;
}
/// Returns whether an SDO answer is an expedited upload that states its size.
inline bool is_expedited_answer(const Frame& frame) {
    return (frame.data[0] & 0xE3U) == 0x43U;
}
/// Returns the number of bytes that an expedited frame carries.
inline std::size_t expedited_size(const Frame& frame) {
    return 4U - ((frame.data[0] >> 2U) & 3U);
}
inline bool is_abort(const Frame& frame) {
    return frame.data[0] == 0x80U;
}
inline bool is_abort(const Frame& frame, std::uint32_t code) {
    return is_abort(frame) && value_of(frame) == code;
}

/// Returns the answer that confirms a download (60h). Index and sub-index are taken from `frame`, the request or an
/// answer to it.
inline Frame confirmation(std::uint8_t node, const Frame& frame) {
    return with_value(with_command(with_id(with_length(frame, 8), sdo_answers + node), 0x60), 0);
}
inline Frame abort_of(std::uint8_t node, const Frame& frame, std::uint32_t code) {
    return with_value(with_command(with_id(with_length(frame, 8), sdo_answers + node), 0x80), code);
}
/// Returns an expedited download of `size` (1 to 4) bytes.
inline Frame download(std::uint8_t node, std::uint16_t index, std::uint8_t subindex, std::size_t size,
                      std::uint32_t value) {
    Frame frame = data_frame(sdo_requests + node, 8);
    frame.data[0] = static_cast<std::uint8_t>(0x23U | ((4U - size) << 2U));
    set_field_le<1, 2>(frame.data, index);
    frame.data[3] = subindex;
    return with_value(frame, value);
}

}  // namespace canproof::test::zoo
