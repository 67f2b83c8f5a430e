// SPDX-License-Identifier: Apache-2.0
#include "host/codegen/write_objects.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>
#include <map>

#include "host/codegen/cpp_text.hpp"
#include "host/codegen/dictionary_rows.hpp"
#include "host/register/layout.hpp"

namespace canproof::host {

namespace {

std::string data_type_word(const std::string& type) {
    return "DataType::" + snake_case(type);
}

std::string rights_words(std::uint8_t bits) {
    static const std::vector<std::pair<std::uint8_t, std::string>> words{
        {rights::read, "rights::read"},         {rights::write, "rights::write"},
        {rights::rpdo, "rights::rpdo"},         {rights::tpdo, "rights::tpdo"},
        {rights::stored, "rights::stored"},     {rights::node_id, "rights::node_id"},
        {rights::constant, "rights::constant"},
    };
    std::vector<std::string> all;
    for (const auto& [right, word] : words) {
        if ((bits & right) != 0U) {
            all.push_back(word);
        }
    }
    return fmt::format("{}", fmt::join(all, " | "));
}

std::string limit_words(const canproof::Limit& limit) {
    static const std::vector<std::string> kinds{"none", "value", "entry", "list", "value_or_zero"};
    const std::string kind = "LimitKind::" + kinds.at(static_cast<std::size_t>(limit.kind));
    return limit.kind == LimitKind::none ? fmt::format("{{{}, 0U, 0}}", kind)
                                         : fmt::format("{{{}, 0x{:08X}U, {}}}", kind, limit.bits, limit.add);
}

std::string entry_words(const EntryRow& row, const Entry& entry) {
    return fmt::format("{{{}U, {}U, {}, {}U, {}, {}, Service::{}}},", row.offset, row.size,
                       row.limit == no_limit ? "no_limit" : fmt::format("{}U", row.limit), row.subindex,
                       data_type_word(entry.type), rights_words(row.rights), entry.service);
}

/// Returns the constant pool or the default image as a table of bytes in C++. Each entry in it has its own line.
std::string value_pool(const std::string& name, const Part& part, const Layout& layout, bool constant, Cells cells) {
    const auto& pool = constant ? layout.constants : layout.image;
    std::map<std::size_t, std::string> comments;  // by offset
    for (std::size_t o = 0; o < part.objects.size(); ++o) {
        const Object& object = part.objects[o];
        for (std::size_t e = 0; e < object.entries.size(); ++e) {
            const Placement& place = layout.placements[o][e];
            if (place.constant == constant && place.size != 0) {
                comments[place.offset] = fmt::format("{} {}", object.id, object.entries[e].name);
                comments.try_emplace(place.offset + std::size_t{place.size}, "padding");
            }
        }
    }
    std::string text =
        fmt::format("{} std::array<std::uint8_t, {}U> {}{{{{\n", storage_words(cells), pool.size(), name);
    for (auto one = comments.begin(); one != comments.end() && one->first < pool.size(); ++one) {
        const auto next = std::next(one);
        const std::size_t end = next == comments.end() ? pool.size() : next->first;
        text += "   ";
        for (std::size_t i = one->first; i < end; ++i) {
            text += fmt::format(" 0x{:02X}U,", pool[i]);
        }
        text += fmt::format("  // {}: {}\n", one->first, one->second);
    }
    return text + "}};\n\n";
}

std::string string_rows(const std::string& type, const std::string& name, const std::vector<std::string>& rows,
                        Cells cells) {
    std::string text = fmt::format("{} std::array<{}, {}U> {}{{{{\n", storage_words(cells), type, rows.size(), name);
    for (const auto& row : rows) {
        text += "    " + row + "\n";
    }
    return text + "}};\n\n";
}

/// Returns the table of hash slots, sixteen in a line.
std::string slot_table(const DictionaryRows& rows) {
    std::string text =
        fmt::format("inline constexpr std::array<std::uint16_t, {}U> object_slots{{{{", rows.slots.size());
    for (std::size_t i = 0; i < rows.slots.size(); ++i) {
        const std::uint16_t slot = rows.slots[i];
        text += i % 16 == 0 ? "\n   " : "";
        text += slot == no_object ? " no_object," : fmt::format(" {}U,", slot);
    }
    return text + "\n}};\n\n";
}

bool has_field(const Entry& entry, const Placement& place) {
    return !place.constant && type_size(entry.type) > 0;
}

std::string field_for(const Object& object, const std::vector<Placement>& places) {
    std::string text;
    const std::string base = fmt::format("o{:04x}_{}", object.index, snake_case(object.name));
    if (object.alike && object.entries.size() > 1 && has_field(object.entries[1], places[1])) {
        text +=
            fmt::format("inline constexpr ArrayField<{}, {}U> {}{{{}U}};  // {}\n", cpp_type(object.entries[1].type),
                        object.entries.size() - 1, base, places[1].offset, object.id);
        if (!has_field(object.entries[0], places[0])) {
            return text;
        }
        return text + fmt::format("inline constexpr Field<{}> o{:04x}_0_{}{{{}U}};  // {}\n",
                                  cpp_type(object.entries[0].type), object.index, snake_case(object.entries[0].name),
                                  places[0].offset, object.id);
    }
    for (std::size_t i = 0; i < object.entries.size(); ++i) {
        const Entry& entry = object.entries[i];
        const std::string name = object.kind == Object::Kind::var ? base
                                                                  : fmt::format("o{:04x}_{}_{}", object.index,
                                                                                entry.subindex, snake_case(entry.name));
        if (has_field(entry, places[i])) {
            text += fmt::format("inline constexpr Field<{}> {}{{{}U}};  // {}\n", cpp_type(entry.type), name,
                                places[i].offset, object.id);
        } else if (!places[i].constant && is_string_type(entry.type)) {
            text += fmt::format("inline constexpr StringField {}{{{}U, {}U}};  // {}\n", name, places[i].offset,
                                places[i].size, object.id);
        }
    }
    return text;
}

/// The text of the rows of each table; each row is one string.
struct RowTexts {
    const std::vector<std::string>& objects;
    const std::vector<std::string>& entries;
    const std::vector<std::string>& limits;
    const std::vector<std::string>& allowed;
};

/// Returns the tables of a dictionary, and the structure that refers to them all.
std::string table_texts(const Part& part, const DictionaryRows& rows, const RowTexts& texts, Cells cells) {
    std::string text = string_rows("ObjectRow", "object_rows", texts.objects, cells);
    text += "// {offset, size, limit row, sub-index, type, rights, service}\n";
    text += string_rows("EntryRow", "entry_rows", texts.entries, cells);
    text += string_rows("LimitRow", "limit_rows", texts.limits, cells);
    text += string_rows("std::uint32_t", "allowed_values", texts.allowed, cells);
    text += slot_table(rows);
    text += value_pool("constant_pool", part, rows.layout, true, cells);
    text += value_pool("default_image", part, rows.layout, false, cells);
    text += fmt::format(
        "inline constexpr DictionaryTables tables{{table_view(object_rows), table_view(entry_rows), "
        "table_view(limit_rows),\n"
        "    table_view(allowed_values), table_view(constant_pool), table_view(default_image), 0x{:08X}U,\n"
        "    table_view(object_slots), 0x{:08X}U, {}U}};\n{}\n",
        rows.layout.fingerprint, rows.slot_factor, rows.layout.settings_at,
        cells == Cells::constant ? "static_assert(is_sound(tables));\n" : "");
    return text;
}

}  // namespace

std::string write_objects(const Part& part, Cells cells) {
    const DictionaryRows rows = make_rows(part, cells == Cells::constant ? Limits::shared : Limits::one_an_entry);
    const Layout& layout = rows.layout;
    std::vector<std::string> objects;
    std::vector<std::string> entries;
    std::string fields;
    for (std::size_t o = 0; o < part.objects.size(); ++o) {
        const Object& object = part.objects[o];
        const char* kind = object.kind == Object::Kind::var     ? "var"
                           : object.kind == Object::Kind::array ? "array"
                                                                : "record";
        objects.push_back(fmt::format("{{0x{:04X}U, {}U, {}U, ObjectKind::{}}},  // {} {}", object.index,
                                      entries.size(), object.entries.size(), kind, object.id, object.name));
        for (const Entry& entry : object.entries) {
            entries.push_back(
                fmt::format("{}  // {} {}", entry_words(rows.entries[entries.size()], entry), object.id, entry.name));
        }
        fields += field_for(object, layout.placements[o]);
    }
    std::vector<std::string> limits;
    for (const LimitRow& row : rows.limits) {
        limits.push_back(fmt::format("{{{}, {}}},", limit_words(row.minimum), limit_words(row.maximum)));
    }
    std::vector<std::string> allowed;
    for (const auto bits : rows.allowed) {
        allowed.push_back(fmt::format("0x{:08X}U,", bits));
    }
    std::string text = heading(part);
    text += "#include <array>\n#include <cstdint>\n\n#include \"firmware/canopen/dictionary_check.hpp\"\n\n";
    text += fmt::format("namespace canproof::generated::{} {{\n\n", part.cpp_name());
    const RowTexts texts{objects, entries, limits, allowed};
    const std::string own = table_texts(part, rows, texts, cells);
    // Some sizes are computed at compile time. They use the tables in `compiled`, which are constant in every build.
    text += cells == Cells::constant
                ? fmt::format("{}namespace compiled {{\nusing generated::{}::tables;\n}}  // namespace compiled\n\n",
                              own, part.cpp_name())
                : fmt::format("namespace compiled {{\n\n{}}}  // namespace compiled\n\n{}",
                              table_texts(part, rows, texts, Cells::constant), own);
    text += fmt::format("inline constexpr std::size_t image_size = {}U;\n\n", layout.image.size());
    text += "namespace field {\n" + fields + "}  // namespace field\n\n";
    return text + fmt::format("}}  // namespace canproof::generated::{}\n", part.cpp_name());
}

}  // namespace canproof::host
