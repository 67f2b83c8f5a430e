// SPDX-License-Identifier: Apache-2.0
#include "host/codegen/cpp_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/base/one_line.hpp"
#include "host/register/literals.hpp"

namespace canproof::host {

std::string heading(const Part& part) {
    return fmt::format(
        "// Written by canproof's speccompiler from\n//   {}\n// Do not edit: change the register.\n#pragma once\n\n",
        fmt::join(part.files, "\n//   "));
}

const char* storage_words(Cells cells) {
    return cells == Cells::constant ? "inline constexpr" : "inline";
}

std::string cpp_type(const std::string& cia_type) {
    if (cia_type == "BOOLEAN") {
        return "bool";
    }
    if (cia_type == "REAL32") {
        return "float";
    }
    if (cia_type == "REAL64") {
        return "double";
    }
    const bool is_unsigned = cia_type.rfind("UNSIGNED", 0) == 0;
    const std::string width = cia_type.substr(is_unsigned ? 8 : 7);
    return fmt::format("std::{}int{}_t", is_unsigned ? "u" : "", width);
}

std::string cpp_integer_type(std::int64_t low, std::int64_t high) {
    if (low < 0) {
        const bool byte = low >= INT8_MIN && high <= INT8_MAX;
        const bool word = low >= INT16_MIN && high <= INT16_MAX;
        const bool dword = low >= INT32_MIN && high <= INT32_MAX;
        return byte ? "std::int8_t" : word ? "std::int16_t" : dword ? "std::int32_t" : "std::int64_t";
    }
    return high <= UINT8_MAX                  ? "std::uint8_t"
           : high <= UINT16_MAX               ? "std::uint16_t"
           : high <= std::int64_t{UINT32_MAX} ? "std::uint32_t"
                                              : "std::uint64_t";
}

std::string cpp_literal(const Value& value, const std::string& cpp_type_name, bool hexadecimal) {
    if (const auto* truth = std::get_if<bool>(&value)) {
        return *truth ? "true" : "false";
    }
    if (cpp_type_name == "bool") {
        return number_of(value).value_or(0.0) != 0.0 ? "true" : "false";
    }
    if (cpp_type_name == "float" || cpp_type_name == "double") {
        std::string text = fmt::format("{}", number_of(value).value_or(0.0));
        if (text.find_first_of(".e") == std::string::npos) {
            text += ".0";
        }
        return cpp_type_name == "float" ? text + "F" : text;
    }
    const auto* given = std::get_if<std::int64_t>(&value);
    const std::int64_t whole = given == nullptr ? 0 : *given;
    if (cpp_type_name.find("uint") == std::string::npos) {
        return fmt::format("{}", whole);
    }
    return !hexadecimal      ? fmt::format("{}U", whole)
           : whole <= 0xFFFF ? fmt::format("0x{:02X}U", whole)
                             : fmt::format("0x{:08X}U", whole);
}

std::string item_comment(const Item& item, const std::string& unit) {
    const std::string in = unit.empty() ? "" : " [" + unit + "]";
    const std::string text = item.text.empty() ? "" : one_line(item.text) + " ";
    const std::string origin = item.sources.empty() ? "derived" : fmt::format("{}", fmt::join(item.sources, ", "));
    return fmt::format("/// {}({}; {}){}\n", text, item.id, origin, in);
}

}  // namespace canproof::host
