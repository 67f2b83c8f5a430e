// Words of the socketcand protocol, which server and client share.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "firmware/canopen/frame.hpp"

namespace canproof::host {

std::vector<std::string> words_of(const std::string& text);
/// A number in hexadecimal of at most eight digits.
std::optional<std::uint32_t> hex_number(const std::string& text, std::uint32_t highest);
/// An identifier written with eight digits has 29 bits.
bool read_identifier(const std::string& text, Frame& frame);
std::string format_identifier(const Frame& frame);
/// Two digits a byte: "0102" to frame.data and frame.length. False when that is no data of a frame.
bool read_bytes(const std::string& text, Frame& frame);

/// Takes the next `< … >` out of `input`: what stands between. Text that is no command is dropped, and so is one that
/// is longer than `longest`: `too_long` is then true. Nothing while the end of the next has not come.
std::optional<std::string> take_command(std::string& input, std::size_t longest, bool& too_long);

}  // namespace canproof::host
