// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/entry_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace canproof::host {

namespace {

std::string limit_words(const Entry& entry, const Limit& limit) {
    return limit.kind == Limit::Kind::object ? limit_name(entry, limit) : to_text(limit.number);
}

}  // namespace

std::string limit_name(const Entry& entry, const Limit& limit) {
    const std::string sum = limit.add == 0 ? "" : fmt::format(" {} {}", limit.add < 0 ? "-" : "+", std::abs(limit.add));
    return fmt::format("{:04X}h:{}{}", limit.index, limit.subindex < 0 ? entry.subindex : limit.subindex, sum);
}

std::string range_words(const Entry& entry) {
    const Range& range = entry.range;
    if (!range.values.empty()) {
        std::vector<std::string> words;
        for (const Value& value : range.values) {
            words.push_back(to_text(value));
        }
        return fmt::format("{}", fmt::join(words, ", "));
    }
    const std::string zero = range.zero ? "0, " : "";
    return range.empty() ? "" : zero + limit_words(entry, range.minimum) + " … " + limit_words(entry, range.maximum);
}

const char* kind_name(const Object& object) {
    switch (object.kind) {
        case Object::Kind::array:
            return "ARRAY";
        case Object::Kind::record:
            return "RECORD";
        default:
            return "VAR";
    }
}

std::string place_words(const Object& object, const Entry& entry) {
    return object.kind == Object::Kind::var ? fmt::format("{:04X}h", object.index)
                                            : fmt::format("{:04X}h:{:02X}", object.index, entry.subindex);
}

unsigned mapped_bits(const Entry& entry) {
    return entry.type == "BOOLEAN" ? 1U : static_cast<unsigned>(type_size(entry.type) * 8U);
}

}  // namespace canproof::host
