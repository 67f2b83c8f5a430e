// SPDX-License-Identifier: Apache-2.0
#include "host/base/utf8.hpp"

#include <algorithm>
#include <cstddef>

namespace canproof::host {

namespace {

constexpr unsigned char first_further = 0x80;  // bytes behind the first of a character: 80h to BFh
constexpr unsigned char last_further = 0xBF;

/// The first byte of a character decides the number of bytes, and the range of the second byte (RFC 3629, 4).
struct Form {
    unsigned char first;
    unsigned char last;
    std::size_t length;
    unsigned char least_second;
    unsigned char most_second;
};
constexpr Form forms[]{{0x00, 0x7F, 1, 0, 0},       {0xC2, 0xDF, 2, 0x80, 0xBF}, {0xE0, 0xE0, 3, 0xA0, 0xBF},
                       {0xE1, 0xEC, 3, 0x80, 0xBF}, {0xED, 0xED, 3, 0x80, 0x9F}, {0xEE, 0xEF, 3, 0x80, 0xBF},
                       {0xF0, 0xF0, 4, 0x90, 0xBF}, {0xF1, 0xF3, 4, 0x80, 0xBF}, {0xF4, 0xF4, 4, 0x80, 0x8F}};

/// Returns the number of bytes of the character at this place; 0 when no character begins there.
std::size_t length_at(const std::string& text, std::size_t at) {
    const auto byte = [&text](std::size_t place) { return static_cast<unsigned char>(text[place]); };
    const auto form = std::find_if(std::begin(forms), std::end(forms),
                                   [&](const Form& one) { return byte(at) >= one.first && byte(at) <= one.last; });
    if (form == std::end(forms) || at + form->length > text.size()) {
        return 0;
    }
    for (std::size_t i = 1; i < form->length; ++i) {
        const unsigned char least = i == 1 ? form->least_second : first_further;
        const unsigned char most = i == 1 ? form->most_second : last_further;
        if (byte(at + i) < least || byte(at + i) > most) {
            return 0;
        }
    }
    return form->length;
}

bool is_control(char one) {
    return (static_cast<unsigned char>(one) < 0x20U && one != '\t' && one != '\n' && one != '\r') || one == '\x7F';
}

}  // namespace

bool is_utf8(const std::string& text) {
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t length = length_at(text, at);
        if (length == 0) {
            return false;
        }
        at += length;
    }
    return true;
}

std::string shown_text(const std::string& text) {
    std::string out;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t length = length_at(text, at);
        out += length == 0 || is_control(text[at]) ? "\xEF\xBF\xBD" : text.substr(at, length);
        at += std::max<std::size_t>(length, 1);
    }
    return out;
}

}  // namespace canproof::host
