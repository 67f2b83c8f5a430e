// SPDX-License-Identifier: Apache-2.0
// Reads and changes LSS frames for the LSS faults.
#pragma once

#include "tests/conformance/zoo/distortions.hpp"

namespace canproof::test::zoo {

constexpr std::uint32_t lss_requests = 0x7E5;
constexpr std::uint32_t lss_answers = 0x7E4;

inline bool is_lss(const Frame& frame, unsigned command) {
    return is_data(frame, lss_requests) && frame.data[0] == command;
}
inline Frame lss_answer(unsigned command, unsigned byte) {
    return with_byte(with_byte(data_frame(lss_answers, 8), 0, command), 1, byte);
}
inline Frame lss_request(unsigned command, unsigned byte) {
    return with_id(lss_answer(command, byte), lss_requests);
}
inline Frame lss_mode(bool configuration) {
    return lss_request(0x04, configuration ? 1 : 0);
}
/// Returns `frame` with 1018h:`number` + 1, one of the four numbers of the slave's identity object, in bytes 1 to 4.
inline Frame with_own_number(WrongSlave& slave, const Frame& frame, unsigned number) {
    Frame own = frame;
    set_field_le<1, 4>(own.data, slave.dictionary().read(0x1018, static_cast<std::uint8_t>(number + 1)));
    return own;
}

/// The key of the note in WrongSlave::notes that is not 0 in LSS configuration. follows_lss() updates this note.
constexpr std::uint32_t lss_mode_note = 0x1000;
inline bool is_configuring(WrongSlave& slave) {
    return slave.notes[lss_mode_note] != 0;
}
/// Extends `distortion` so that is_configuring() follows the LSS state. The hooks see the state before their frame.
Distortion follows_lss(Distortion distortion);

/// Serves LSS requests by `serve`. If `serve` returns false, the correct slave serves the request.
Distortion serves_lss(std::function<bool(WrongSlave&, const Frame&)> serve);
/// Changes the LSS answers of the slave.
Distortion answers_lss_otherwise(FrameChange change);

}  // namespace canproof::test::zoo
