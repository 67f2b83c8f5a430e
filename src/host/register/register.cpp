// SPDX-License-Identifier: Apache-2.0
#include "host/register/register.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <string_view>

namespace canproof::host {

std::vector<std::string> origins(const Item& item) {
    std::vector<std::string> all = item.sources;
    if (!item.derived.empty()) {
        all.push_back("derived: " + item.derived);
    }
    return all;
}

std::string to_text(const Value& value) {
    struct Printer {
        std::string operator()(std::monostate) const { return ""; }
        std::string operator()(bool b) const { return b ? "true" : "false"; }
        std::string operator()(std::int64_t i) const { return fmt::format("{}", i); }
        std::string operator()(double d) const { return fmt::format("{}", d); }
        std::string operator()(const std::string& s) const { return s; }
    };
    return std::visit(Printer{}, value);
}

std::vector<std::string> Signal::names() const {
    std::vector<std::string> all;
    for (int n = 1; n <= count; ++n) {
        std::string one = name;
        const auto at = one.find("{n}");
        if (at != std::string::npos) {
            one.replace(at, 3, std::to_string(n));
        }
        all.push_back(one);
    }
    return all;
}

const Section* Manual::describing(const std::string& ref) const {
    const auto is_meant = [&](const Section& one) {
        return one.ref == ref || std::find(one.objects.begin(), one.objects.end(), ref) != one.objects.end();
    };
    const auto found = std::find_if(sections.begin(), sections.end(), is_meant);
    return found == sections.end() ? nullptr : &*found;
}

std::string Part::cpp_name() const {
    return snake_case(name);
}

const Part* Register::part(const std::string& name) const {
    const auto found = std::find_if(parts.begin(), parts.end(), [&](const Part& p) { return p.name == name; });
    return found == parts.end() ? nullptr : &*found;
}

const Manual* Register::manual(const std::string& key) const {
    const auto found = std::find_if(manuals.begin(), manuals.end(), [&](const Manual& m) { return m.key == key; });
    return found == manuals.end() ? nullptr : &*found;
}

const Enumeration* Register::enumeration(const Part& in, const std::string& id) const {
    for (const Part* place : {&in, part("canopen")}) {
        if (place == nullptr) {
            continue;
        }
        for (const auto& one : place->enumerations) {
            if (one.id == id) {
                return &one;
            }
        }
    }
    return nullptr;
}

namespace {

struct TypeFacts {
    std::string_view word;
    std::size_t size;
    std::int64_t minimum;
    std::int64_t maximum;
};

constexpr std::int64_t none = 0;
constexpr std::array<TypeFacts, 14> types{{{"UNSIGNED8", 1, 0, UINT8_MAX},
                                           {"UNSIGNED16", 2, 0, UINT16_MAX},
                                           {"UNSIGNED32", 4, 0, UINT32_MAX},
                                           {"INTEGER16", 2, INT16_MIN, INT16_MAX},
                                           {"INTEGER32", 4, INT32_MIN, INT32_MAX},
                                           {"BOOLEAN", 1, 0, 1},
                                           {"INTEGER8", 1, INT8_MIN, INT8_MAX},
                                           {"REAL32", 4, none, none},
                                           {"VISIBLE_STRING", 0, none, none},
                                           {"OCTET_STRING", 0, none, none},
                                           {"DOMAIN", 0, none, none},
                                           {"INTEGER64", 8, INT64_MIN, INT64_MAX},
                                           {"UNSIGNED64", 8, 0, INT64_MAX},
                                           {"REAL64", 8, none, none}}};

constexpr std::size_t type_slots = 64;

/// Returns the slot of a type (a hash of its name) in `types_by_slot`. No two known types have the same slot.
constexpr std::size_t type_slot(std::string_view type) {
    return type.empty() ? 0 : (5 * type.size() + static_cast<unsigned char>(type.back())) % type_slots;
}

/// The facts about each CiA type at its slot (type_slot()). An unused slot has an empty word.
constexpr std::array<TypeFacts, type_slots> types_by_slot = [] {
    std::array<TypeFacts, type_slots> slots{};
    for (const TypeFacts& one : types) {
        slots[type_slot(one.word)] = one;
    }
    return slots;
}();

constexpr bool has_each_type_a_slot() {
    for (const TypeFacts& one : types) {
        if (types_by_slot[type_slot(one.word)].word != one.word) {
            return false;
        }
    }
    return true;
}
static_assert(has_each_type_a_slot());

/// Returns the facts about a type; nullptr for a text that is no type.
const TypeFacts* facts(std::string_view type) {
    const TypeFacts& found = types_by_slot[type_slot(type)];
    return !type.empty() && found.word == type ? &found : nullptr;
}

}  // namespace

std::size_t type_size(const std::string& type) {
    const TypeFacts* found = facts(type);
    return found == nullptr ? 0 : found->size;
}

bool is_known_type(const std::string& type) {
    return facts(type) != nullptr;
}

bool is_string_type(const std::string& type) {
    const std::string_view word{type};  // std::string_view compares the lengths first
    return word == "VISIBLE_STRING" || word == "OCTET_STRING";
}

std::optional<std::pair<std::int64_t, std::int64_t>> integer_limits(const std::string& type) {
    const TypeFacts* found = facts(type);
    if (found == nullptr || found->maximum == none) {
        return std::nullopt;
    }
    return std::pair{found->minimum, found->maximum};
}

std::string snake_case(const std::string& text) {
    std::string out;
    for (const char c : text) {
        const auto u = static_cast<unsigned char>(c);
        if (std::isalnum(u) != 0) {
            out += static_cast<char>(std::tolower(u));
        } else if (!out.empty() && out.back() != '_') {
            out += '_';
        }
    }
    while (!out.empty() && out.back() == '_') {
        out.pop_back();
    }
    return out;
}

std::string pascal_case(const std::string& text) {
    std::string out;
    bool upper = true;
    for (const char c : snake_case(text)) {
        if (c == '_') {
            upper = true;
        } else {
            out += upper ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
            upper = false;
        }
    }
    return out;
}

}  // namespace canproof::host
