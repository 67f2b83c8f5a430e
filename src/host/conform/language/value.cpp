// SPDX-License-Identifier: Apache-2.0
#include "host/conform/language/value.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace canproof::host::conform {

namespace {

constexpr std::size_t most_number_bytes = 8;
constexpr std::size_t most_shown_bytes = 64;

}  // namespace

std::int64_t number_of(const Value& value) {
    if (!value.bytes) {
        return value.number;
    }
    if (value.bytes->size() > most_number_bytes) {
        throw BrokenCase{fmt::format("{} bytes are too many for a number; use at most 8 bytes", value.bytes->size())};
    }
    return from_little_endian(*value.bytes, 0, value.bytes->size());
}

const Bytes& bytes_of(const Value& value) {
    if (!value.bytes) {
        throw BrokenCase{fmt::format("{} is a number; write le({}, WIDTH) for its bytes", value.number, value.number)};
    }
    return *value.bytes;
}

Bytes little_endian(std::int64_t number, std::size_t count) {
    Bytes bytes;
    auto rest = static_cast<std::uint64_t>(number);
    for (std::size_t i = 0; i < count; ++i) {
        bytes.push_back(static_cast<std::uint8_t>(rest & 0xFFU));
        rest >>= 8U;
    }
    return bytes;
}

std::int64_t from_little_endian(const Bytes& bytes, std::size_t start, std::size_t count) {
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < std::min(count, most_number_bytes) && start + i < bytes.size(); ++i) {
        number |= std::uint64_t{bytes[start + i]} << (8U * i);
    }
    return static_cast<std::int64_t>(number);
}

std::string hex_words(const Bytes& bytes) {
    std::string text;
    for (std::size_t i = 0; i < std::min(bytes.size(), most_shown_bytes); ++i) {
        text += fmt::format("{}{:02X}", i == 0 ? "" : " ", bytes[i]);
    }
    return bytes.size() > most_shown_bytes ? fmt::format("{} … ({} bytes)", text, bytes.size()) : text;
}

std::string words_of(const Value& value) {
    if (value.bytes) {
        return value.bytes->empty() ? "no bytes" : hex_words(*value.bytes);
    }
    return fmt::format("{} ({:X}h)", value.number, static_cast<std::uint64_t>(value.number));
}

bool same(const Value& a, const Value& b) {
    return a.bytes && b.bytes ? *a.bytes == *b.bytes : number_of(a) == number_of(b);
}

}  // namespace canproof::host::conform
