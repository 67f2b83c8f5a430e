#include "host/speccompiler/eds_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <map>

#include "host/speccompiler/literals.hpp"

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

std::optional<std::string> limit_text(const Entry& entry, const Limit& limit, bool lowest) {
    if (limit.kind == Limit::Kind::number && lowest && entry.range.zero) {
        return "0";  // a data sheet cannot say that the values next to it are refused
    }
    if (limit.kind == Limit::Kind::number) {
        return number_text(limit.number, entry.type);
    }
    const auto& values = entry.range.values;
    if (values.empty()) {
        return std::nullopt;
    }
    const auto less = [](const Value& a, const Value& b) { return number_of(a) < number_of(b); };
    const auto [low, high] = std::minmax_element(values.begin(), values.end(), less);
    return number_text(lowest ? *low : *high, entry.type);
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

std::string eds_default(const Entry& entry) {
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
    return number_text(entry.value, entry.type);
}

std::optional<std::string> eds_low_limit(const Entry& entry) {
    return limit_text(entry, entry.range.minimum, true);
}

std::optional<std::string> eds_high_limit(const Entry& entry) {
    return limit_text(entry, entry.range.maximum, false);
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
        const bool mapping = (object.index & 0xFE00U) == 0x1600U || (object.index & 0xFE00U) == 0x1A00U;
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
