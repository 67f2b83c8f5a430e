// SPDX-License-Identifier: Apache-2.0
#include "host/conform/language/object_reference.hpp"

#include <fmt/format.h>

#include "host/conform/language/expression.hpp"

namespace canproof::host::conform {

namespace {

constexpr std::int64_t highest_index = 0xFFFF;
constexpr std::int64_t highest_subindex = 0xFF;

ObjectPlace place_of(std::int64_t index, std::int64_t subindex) {
    if (index < 0 || index > highest_index || subindex < 0 || subindex > highest_subindex) {
        throw BrokenCase{fmt::format("{:X}h sub {:X}h is no object; the highest is {:X}h sub {:X}h", index, subindex,
                                     highest_index, highest_subindex)};
    }
    return {static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(subindex)};
}

ObjectPlace place_of(const Value& entry) {
    const auto index = entry.fields ? entry.fields("index") : std::nullopt;
    const auto subindex = entry.fields ? entry.fields("sub") : std::nullopt;
    if (!index || !subindex) {
        throw BrokenCase{
            "the variable has no index and sub-index; write for example 1017:00, or two variables: $index:$sub"};
    }
    return place_of(number_of(*index), number_of(*subindex));
}

Expression parse_term(Scanner& line) {
    if (line.peek() == '$') {
        return parse_variable(line);
    }
    if (line.peek() != '(' && line.peek_token().find(':') == std::string::npos && line.peek_token().size() > 2) {
        line.fail(fmt::format("`{}` is no object", line.peek_token()), "write index:sub, such as 1017:00, or $E");
    }
    return parse_operand(line, Radix::hexadecimal);
}

}  // namespace

std::string words_of(const ObjectPlace& place) {
    return fmt::format("{:04X}h:{:02X}", place.index, place.subindex);
}

Bytes multiplexer(const ObjectPlace& place) {
    Bytes bytes = little_endian(place.index, 2);
    bytes.push_back(place.subindex);
    return bytes;
}

ObjectReference parse_object(Scanner& line) {
    const Expression first = parse_term(line);
    if (!line.take(":")) {
        return [first](const Scope& scope) { return place_of(first(scope)); };
    }
    const Expression second = parse_term(line);
    return [first, second](const Scope& scope) { return place_of(number_of(first(scope)), number_of(second(scope))); };
}

}  // namespace canproof::host::conform
