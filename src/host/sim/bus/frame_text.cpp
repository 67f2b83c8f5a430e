// SPDX-License-Identifier: Apache-2.0
#include "host/sim/bus/frame_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace canproof::host {

namespace {

constexpr std::size_t base_digits = 3;
constexpr std::size_t extended_digits = 8;
constexpr std::uint32_t highest_base = 0x7FFU;
constexpr std::uint32_t highest_extended = 0x1FFFFFFFU;
constexpr std::uint32_t error_flag = 0x20000000U;  // the only bit of an error frame's identifier above bit 28
constexpr unsigned no_digit = 16;

unsigned digit_of(char c) {
    return c >= '0' && c <= '9'   ? static_cast<unsigned>(c - '0')
           : c >= 'A' && c <= 'F' ? static_cast<unsigned>(c - 'A') + 10U
           : c >= 'a' && c <= 'f' ? static_cast<unsigned>(c - 'a') + 10U
                                  : no_digit;
}

/// Parses a hexadecimal number. The callers pass one to eight characters. Returns nothing when a character is no
/// hexadecimal digit.
std::optional<std::uint32_t> hexadecimal(std::string_view digits) {
    std::uint32_t value = 0;
    for (const char c : digits) {
        const unsigned digit = digit_of(c);
        if (digit == no_digit) {
            return std::nullopt;
        }
        value = (value << 4U) | digit;
    }
    return value;
}

bool is_identifier(std::string_view id) {
    return id.size() == base_digits || id.size() == extended_digits;
}

TextFault read_data(Frame& frame, std::string_view data) {
    bool sound = data.size() % 2 == 0 && data.size() <= 2 * max_frame_length;
    frame.length = static_cast<std::uint8_t>(sound ? data.size() / 2 : 0);
    for (std::size_t i = 0; sound && i < frame.length; ++i) {
        const unsigned high = digit_of(data[2 * i]);
        const unsigned low = digit_of(data[2 * i + 1]);
        sound = high != no_digit && low != no_digit;
        frame.data[i] = static_cast<std::uint8_t>((high << 4U) | low);
    }
    return sound ? TextFault{} : fmt::format("data `{}` is no sequence of zero to eight bytes in hexadecimal", data);
}

/// Removes a length code after `_`. candump writes the codes 9 to 15 in this form; in classic CAN, each of these codes
/// means eight bytes.
TextFault cut_length_code(std::string_view& data, bool& coded) {
    const auto at = data.find('_');
    coded = at != std::string_view::npos;
    if (!coded) {
        return std::nullopt;
    }
    const std::string_view code = data.substr(at + 1);
    data = data.substr(0, at);
    const bool has_eight = data.size() == 2 * max_frame_length || data == "R8" || data == "r8";
    const unsigned value = code.size() == 1 ? digit_of(code.front()) : no_digit;
    if (!has_eight || value <= max_frame_length || value == no_digit) {
        return fmt::format("`_{}` is no length code from 9 to F after eight bytes", code);
    }
    return std::nullopt;
}

TextFault read_remote(Frame& frame, std::string_view length) {
    frame.remote = true;
    if (length.size() > 1 || (length.size() == 1 && (length.front() < '0' || length.front() > '8'))) {
        return fmt::format("`{}` is no length from 0 to 8 after R", length);
    }
    frame.length = length.empty() ? std::uint8_t{0} : static_cast<std::uint8_t>(length.front() - '0');
    return std::nullopt;
}

/// Appends `digits` hexadecimal digits. Uses no formatting library, because a log can have thousands of frames a
/// second.
void append_hex(std::string& text, std::uint32_t value, unsigned digits) {
    for (unsigned left = digits; left > 0U; --left) {
        text += "0123456789ABCDEF"[(value >> (4U * (left - 1U))) & 0xFU];
    }
}

}  // namespace

TextFault read_frame_text(std::string_view text, FrameText& read) {
    const auto hash = std::min(text.find('#'), text.size());
    const std::string_view id = text.substr(0, hash);
    const bool has_identifier = is_identifier(id) && hash < text.size();
    const auto number = has_identifier ? hexadecimal(id) : std::nullopt;
    if (!number) {
        return fmt::format("`{}` has no identifier of three or eight hexadecimal digits before #", text);
    }
    read = FrameText{};
    read.frame.extended = id.size() == extended_digits;
    read.frame.id = *number;
    if (*number > (read.frame.extended ? highest_extended : highest_base)) {
        return fmt::format("identifier {} is too large; the largest are 7FF and 1FFFFFFF", id);
    }
    std::string_view data = text.substr(hash + 1);
    if (TextFault fault = cut_length_code(data, read.coded)) {
        return fault;
    }
    const bool remote = !data.empty() && (data.front() == 'R' || data.front() == 'r');
    return remote ? read_remote(read.frame, data.substr(1)) : read_data(read.frame, data);
}

TextFault read_logged_frame(std::string_view text, FrameText& read) {
    const auto hash = text.find('#');
    if (hash == extended_digits) {
        const auto number = hexadecimal(text.substr(0, hash));
        if (number && (*number & ~highest_extended) == error_flag) {
            read = FrameText{};
            read.error = true;
            return read_data(read.frame, text.substr(hash + 1));
        }
    }
    return read_frame_text(text, read);
}

bool are_alike(const Frame& a, const Frame& b) {
    return a.id == b.id && a.extended == b.extended && a.remote == b.remote && a.length == b.length &&
           std::equal(a.payload().data(), a.payload().data() + a.payload().size(), b.payload().data());
}

void append_frame(std::string& text, const Frame& frame) {
    append_hex(text, frame.id, frame.extended ? extended_digits : base_digits);
    text += '#';
    if (frame.remote) {
        text += 'R';
        if (frame.length > 0) {
            text += std::to_string(frame.length);
        }
        return;
    }
    for (std::size_t i = 0; i < frame.length; ++i) {
        append_hex(text, frame.data[i], 2U);
    }
}

}  // namespace canproof::host
