// SPDX-License-Identifier: Apache-2.0
#include "host/conform/language/functions.hpp"

#include <algorithm>

namespace canproof::host::conform {

namespace {

constexpr std::int64_t longest_bytes = std::int64_t{1} << 20U;
constexpr unsigned crc_polynomial = 0x1021U;
constexpr std::int64_t segment_size = 7;

std::size_t count_of(const Value& value) {
    const std::int64_t count = number_of(value);
    if (count < 0 || count > longest_bytes) {
        throw BrokenCase{words_of(value) + " is not a possible number of bytes; use 0 to 1048576"};
    }
    return static_cast<std::size_t>(count);
}

/// Returns as many test bytes as given[0] says. No two of the first 65536 SDO segments (of seven bytes each) are the
/// same.
Value pattern(const std::vector<Value>& given) {
    Bytes bytes;
    for (std::size_t i = 0; i < count_of(given[0]); ++i) {
        const auto segment = static_cast<unsigned>(i / segment_size);
        const auto place = static_cast<unsigned>(i % segment_size);
        bytes.push_back(static_cast<std::uint8_t>(place == 0 ? segment : place == 1 ? segment >> 8U : 17U * i + 1U));
    }
    return Value{bytes};
}

Value slice(const std::vector<Value>& given) {
    const Bytes& all = bytes_of(given[0]);
    const std::size_t start = std::min(count_of(given[1]), all.size());
    const std::size_t count = std::min(count_of(given[2]), all.size() - start);
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(start);
    return Value{Bytes(first, first + static_cast<std::ptrdiff_t>(count))};
}

Value join(const std::vector<Value>& given) {
    Bytes all = bytes_of(given[0]);
    const Bytes& more = bytes_of(given[1]);
    all.insert(all.end(), more.begin(), more.end());
    return Value{all};
}

const std::vector<LanguageFunction>& functions() {
    static const std::vector<LanguageFunction> all{
        {"crc", 1, [](const auto& given) { return Value{std::int64_t{block_crc(bytes_of(given[0]))}}; }},
        {"join", 2, join},
        {"le", 2, [](const auto& given) { return Value{little_endian(number_of(given[0]), count_of(given[1]))}; }},
        {"max", 2, [](const auto& given) { return Value{std::max(number_of(given[0]), number_of(given[1]))}; }},
        {"min", 2, [](const auto& given) { return Value{std::min(number_of(given[0]), number_of(given[1]))}; }},
        {"number", 1, [](const auto& given) { return Value{number_of(given[0])}; }},
        {"pattern", 1, pattern},
        {"size", 1, [](const auto& given) { return Value{static_cast<std::int64_t>(bytes_of(given[0]).size())}; }},
        {"slice", 3, slice},
        {"zeros", 1, [](const auto& given) { return Value{Bytes(count_of(given[0]))}; }},
    };
    return all;
}

}  // namespace

const LanguageFunction* find_function(const std::string& name) {
    const auto found = std::find_if(functions().begin(), functions().end(),
                                    [&](const LanguageFunction& one) { return one.name == name; });
    return found == functions().end() ? nullptr : &*found;
}

std::string function_names() {
    std::string text = "hex";
    for (const LanguageFunction& one : functions()) {
        text += ", " + one.name;
    }
    return text;
}

std::uint16_t block_crc(const Bytes& bytes) {
    unsigned crc = 0;
    for (const std::uint8_t byte : bytes) {
        crc ^= unsigned{byte} << 8U;
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc & 0x8000U) != 0U ? (crc << 1U) ^ crc_polynomial : crc << 1U;
        }
        crc &= 0xFFFFU;
    }
    return static_cast<std::uint16_t>(crc);
}

}  // namespace canproof::host::conform
