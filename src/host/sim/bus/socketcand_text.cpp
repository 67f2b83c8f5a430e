// SPDX-License-Identifier: Apache-2.0
#include "host/sim/bus/socketcand_text.hpp"

#include <fmt/format.h>

#include <sstream>

namespace canproof::host {

namespace {

constexpr std::size_t extended_digits = 8;

}  // namespace

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream in{text};
    std::vector<std::string> words;
    for (std::string word; in >> word;) {
        words.push_back(word);
    }
    return words;
}

std::optional<std::uint32_t> hex_number(const std::string& text, std::uint32_t highest) {
    if (text.empty() || text.size() > 8 || text.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos) {
        return std::nullopt;
    }
    const auto number = static_cast<std::uint32_t>(std::stoul(text, nullptr, 16));
    return number <= highest ? std::optional{number} : std::nullopt;
}

bool read_identifier(const std::string& text, Frame& frame) {
    frame.extended = text.size() == extended_digits;
    const auto id = hex_number(text, frame.extended ? 0x1FFFFFFFU : 0x7FFU);
    frame.id = id.value_or(0U);
    return id.has_value();
}

std::string format_identifier(const Frame& frame) {
    return frame.extended ? fmt::format("{:08X}", frame.id) : fmt::format("{:03X}", frame.id);
}

bool read_bytes(const std::string& text, Frame& frame) {
    if (text.size() % 2 != 0 || text.size() / 2 > max_frame_length) {
        return false;
    }
    frame.length = static_cast<std::uint8_t>(text.size() / 2);
    for (std::size_t i = 0; i < frame.length; ++i) {
        const auto byte = hex_number(text.substr(2 * i, 2), 0xFFU);
        if (!byte) {
            return false;
        }
        frame.data[i] = static_cast<std::uint8_t>(*byte);
    }
    return true;
}

std::optional<std::string> take_command(std::string& input, std::size_t longest, bool& too_long) {
    input.erase(0, input.find('<'));  // without `<`, find() returns npos and the whole text is erased
    const auto end = input.find('>');
    too_long = end == std::string::npos ? input.size() > longest : end > longest;
    if (too_long) {
        input.erase(0, longest);
        return std::nullopt;
    }
    if (end == std::string::npos) {
        return std::nullopt;
    }
    std::string command = input.substr(1, end - 1);
    input.erase(0, end + 1);
    return command;
}

}  // namespace canproof::host
