// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/write_objects_toml.hpp"

#include <fmt/format.h>

#include <cmath>

#include "host/register/toml_string.hpp"

namespace canproof::host {

namespace {

/// Returns a real number in TOML. A finite number always gets a decimal point or an exponent.
std::string real(double number) {
    if (!std::isfinite(number)) {
        return std::isnan(number) ? "nan" : number > 0 ? "inf" : "-inf";
    }
    const std::string text = fmt::format("{}", number);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string literal(const Value& value) {
    if (const auto* text = std::get_if<std::string>(&value)) {
        return toml_string(*text);
    }
    const auto* number = std::get_if<double>(&value);
    return number == nullptr ? to_text(value) : real(*number);
}

std::string default_of(const Entry& entry) {
    const auto* base = std::get_if<std::int64_t>(&entry.value);
    if (entry.node_id) {
        return fmt::format("\"$NODEID+0x{:X}\"", base == nullptr ? 0 : *base);
    }
    return literal(entry.value);
}

std::string limit(const char* key, const Limit& one) {
    return one.kind == Limit::Kind::number ? fmt::format("{} = {}", key, literal(one.number)) : "";
}

std::string range_of(const Range& range) {
    std::string text;
    for (const Value& value : range.values) {
        text += fmt::format("{}{}", text.empty() ? "" : ", ", literal(value));
    }
    if (!text.empty()) {
        return fmt::format("{{ values = [{}] }}", text);
    }
    const std::string low = limit("min", range.minimum);
    const std::string high = limit("max", range.maximum);
    return low.empty() && high.empty()
               ? ""
               : fmt::format("{{ {}{}{} }}", low, low.empty() || high.empty() ? "" : ", ", high);
}

/// Returns type, access and all other fields of one entry; each line begins with `indent`.
std::string fields(const Entry& entry, const std::string& indent) {
    std::string text = fmt::format("{0}type = \"{1}\"\n{0}access = \"{2}\"\n", indent, entry.type, entry.access);
    if (!std::holds_alternative<std::monostate>(entry.value)) {
        text += fmt::format("{}default = {}\n", indent, default_of(entry));
    }
    if (const std::string range = range_of(entry.range); !range.empty()) {
        text += fmt::format("{}range = {}\n", indent, range);
    }
    if (entry.mapping != "none") {
        text += fmt::format("{}mapping = \"{}\"\n", indent, entry.mapping);
    }
    if (entry.stored != (entry.access == "rw")) {
        text += fmt::format("{}stored = {}\n", indent, entry.stored);
    }
    if (entry.service != "none") {
        text += fmt::format("{}service = \"{}\"\n", indent, entry.service);
    }
    if (entry.live && entry.access == "ro") {
        text += fmt::format("{}live = true\n", indent);
    }
    if (entry.length != 0 && is_string_type(entry.type)) {
        text += fmt::format("{}length = {}\n", indent, entry.length);
    }
    return text;
}

std::string object_text(const Object& object, const std::string& source) {
    std::string text = fmt::format("\n[[object]]\nindex = 0x{:04X}\nname = {}\nsource = [{}]\n", object.index,
                                   toml_string(object.name), toml_string(source));
    if (object.kind == Object::Kind::var) {
        return text + (object.entries.empty() ? "" : fields(object.entries.front(), ""));
    }
    text += fmt::format("kind = \"{}\"\n", object.kind == Object::Kind::array ? "array" : "record");
    for (const Entry& entry : object.entries) {
        text += fmt::format("  [[object.entry]]\n  sub = {}\n  name = {}\n{}", entry.subindex, toml_string(entry.name),
                            fields(entry, "  "));
    }
    return text;
}

}  // namespace

std::string write_objects_toml(const Part& part, const std::string& source) {
    std::string text = "# The object dictionary of the data sheet.\n";
    for (const Object& object : part.objects) {
        text += object_text(object, source);
    }
    return text;
}

}  // namespace canproof::host
