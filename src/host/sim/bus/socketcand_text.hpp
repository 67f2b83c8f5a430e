// SPDX-License-Identifier: Apache-2.0
// Parses and formats the parts of the socketcand protocol that server and client have in common.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "firmware/canopen/frame.hpp"

namespace canproof::host {

std::vector<std::string> words_of(const std::string& text);
/// Parses a hexadecimal number of at most eight digits. Returns nothing for any other text, and for a number greater
/// than `highest`.
std::optional<std::uint32_t> hex_number(const std::string& text, std::uint32_t highest);
/// Parses an identifier. An identifier with eight digits has 29 bits, any other has 11 bits. Returns false for an
/// invalid identifier.
bool read_identifier(const std::string& text, Frame& frame);
std::string format_identifier(const Frame& frame);
/// Parses two hexadecimal digits for each byte, such as "0102", into frame.data and frame.length. Returns false for any
/// other text.
bool read_bytes(const std::string& text, Frame& frame);

/// Removes the next `< … >` from `input` and returns its content; nothing while the closing `>` is missing. Drops other
/// text. Also drops a command that is longer than `longest`, and sets `too_long`.
std::optional<std::string> take_command(std::string& input, std::size_t longest, bool& too_long);

}  // namespace canproof::host
