// SPDX-License-Identifier: Apache-2.0
// Common parsing and formatting of the socketcand protocol's server and client.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "firmware/canopen/frame.hpp"

namespace canproof::host {

std::vector<std::string> words_of(const std::string& text);
/// Parses a hexadecimal number of at most eight digits and at most `highest`.
std::optional<std::uint32_t> hex_number(const std::string& text, std::uint32_t highest);
/// Parses an identifier; eight digits mean 29 bits.
bool read_identifier(const std::string& text, Frame& frame);
std::string format_identifier(const Frame& frame);
/// Parses two digits per byte, such as "0102", into frame.data and frame.length. Returns false for invalid data.
bool read_bytes(const std::string& text, Frame& frame);

/// Removes the next `< … >` from `input` and returns its content; nothing while it is incomplete. Other text is
/// dropped. A command longer than `longest` is dropped as well, and sets `too_long`.
std::optional<std::string> take_command(std::string& input, std::size_t longest, bool& too_long);

}  // namespace canproof::host
