// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/eds_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <map>

#include "host/base/cia301.hpp"
#include "host/register/literals.hpp"

namespace canproof::host {

namespace {

std::string number_text(const Value& value, const std::string& type) {
    if (const auto* truth = std::get_if<bool>(&value)) {
        return *truth ? "1" : "0";
    }
    const auto* whole = std::get_if<std::int64_t>(&value);
    if (whole != nullptr && (type == "UNSIGNED32" || type == "UNSIGNED64")) {
        return fmt::format("0x{:X}", static_cast<std::uint64_t>(*whole));
    }
    return to_text(value);
}

/// Returns the bits of a REAL32 or REAL64 as a hexadecimal number.
std::string real_bits(double value, const std::string& type) {
    if (type == "REAL32") {
        const auto single = static_cast<float>(value);
        std::uint32_t bits = 0;
        std::memcpy(&bits, &single, sizeof bits);
        return fmt::format("0x{:08X}", bits);
    }
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return fmt::format("0x{:016X}", bits);
}

std::string value_text(const Value& value, const std::string& type, Reals reals) {
    const auto number = number_of(value);
    return reals == Reals::bits && is_real_type(type) && number ? real_bits(*number, type) : number_text(value, type);
}

std::optional<std::string> limit_text(const Entry& entry, const Limit& limit, bool lowest, Reals reals) {
    if (reals == Reals::without_limits && is_real_type(entry.type)) {
        return std::nullopt;
    }
    if (limit.kind == Limit::Kind::number && lowest && entry.range.zero) {
        // 0 is allowed although it is below the minimum; a data sheet cannot describe the gap between 0 and the minimum
        return "0";
    }
    if (limit.kind == Limit::Kind::number) {
        return value_text(limit.number, entry.type, reals);
    }
    const auto& values = entry.range.values;
    if (values.empty()) {
        return std::nullopt;
    }
    const auto less = [](const Value& a, const Value& b) { return number_of(a) < number_of(b); };
    const auto [low, high] = std::minmax_element(values.begin(), values.end(), less);
    return value_text(lowest ? *low : *high, entry.type, reals);
}

}  // namespace

unsigned data_type_number(const std::string& type) {
    static const std::map<std::string, unsigned> numbers{
        {"BOOLEAN", 0x01},        {"INTEGER8", 0x02},     {"INTEGER16", 0x03},  {"INTEGER32", 0x04},
        {"UNSIGNED8", 0x05},      {"UNSIGNED16", 0x06},   {"UNSIGNED32", 0x07}, {"REAL32", 0x08},
        {"VISIBLE_STRING", 0x09}, {"OCTET_STRING", 0x0A}, {"DOMAIN", 0x0F},     {"REAL64", 0x11},
        {"INTEGER64", 0x15},      {"UNSIGNED64", 0x1B}};
    const auto found = numbers.find(type);
    return found == numbers.end() ? 0U : found->second;
}

unsigned object_code(const Object& object) {
    const bool domain = object.kind == Object::Kind::var && object.entries.front().type == "DOMAIN";
    return domain ? 2U : static_cast<unsigned>(object.kind);
}

Object as_in_sheet(const Object& object) {
    Object sheet = object;
    if (object.index == cia301::error_list && object.kind != Object::Kind::var) {
        Range counted;
        counted.minimum.kind = counted.maximum.kind = Limit::Kind::number;
        counted.minimum.number = std::int64_t{0};
        counted.maximum.number = static_cast<std::int64_t>(object.entries.size()) - 1;
        sheet.entries.front().range = counted;
    }
    return sheet;
}

std::string eds_default(const Entry& entry, Reals reals) {
    if (entry.node_id) {
        return fmt::format("$NODEID+0x{:X}", std::get<std::int64_t>(entry.value));
    }
    if (entry.type == "OCTET_STRING") {
        std::string digits;
        for (const char c : to_text(entry.value)) {
            digits += fmt::format("{:02X}", static_cast<unsigned char>(c));
        }
        return digits;
    }
    return value_text(entry.value, entry.type, reals);
}

std::optional<std::string> eds_low_limit(const Entry& entry, Reals reals) {
    return limit_text(entry, entry.range.minimum, true, reals);
}

std::optional<std::string> eds_high_limit(const Entry& entry, Reals reals) {
    return limit_text(entry, entry.range.maximum, false, reals);
}

std::string eds_access(const Entry& entry) {
    if (entry.access == "rw" && entry.mapping == "tpdo") {
        return "rwr";
    }
    if (entry.access == "rw" && entry.mapping == "rpdo") {
        return "rww";
    }
    return entry.access;
}

std::size_t count_objects(const Part& device, unsigned first, unsigned last) {
    return static_cast<std::size_t>(std::count_if(device.objects.begin(), device.objects.end(), [&](const Object& o) {
        return o.index >= first && o.index <= last;
    }));
}

std::size_t granularity(const Part& device) {
    bool changeable = false;
    for (const Object& object : device.objects) {
        const bool mapping = cia301::is_pdo_mapping(object.index);
        for (const Entry& entry : object.entries) {
            changeable = changeable || (mapping && entry.access == "rw");
        }
    }
    return changeable ? 8U : 0U;
}

std::int64_t whole_default(const Part& device, unsigned index, unsigned subindex) {
    for (const Object& object : device.objects) {
        for (const Entry& entry : object.entries) {
            const auto* whole = std::get_if<std::int64_t>(&entry.value);
            if (object.index == index && entry.subindex == subindex && whole != nullptr) {
                return *whole;
            }
        }
    }
    return 0;
}

Date manual_date(const Register& content, const Part& device) {
    const Manual* manual = content.manual(device.info.manual);
    Date date;
    if (manual == nullptr || std::sscanf(manual->date.c_str(), "%d-%d-%d", &date.year, &date.month, &date.day) != 3) {
        return {};
    }
    return date;
}

}  // namespace canproof::host
