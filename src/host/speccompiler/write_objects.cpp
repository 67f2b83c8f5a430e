#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstring>

#include "host/speccompiler/writers.hpp"

namespace canproof::host {

namespace {

const std::string raw_type(const std::string& type) {
    std::string lower = snake_case(type);
    return "DataType::" + lower;
}

std::string rights_of(const Entry& entry, bool constant) {
    std::vector<std::string> all;
    if (entry.access != "wo")
        all.emplace_back("rights::read");
    if (entry.access == "rw" || entry.access == "wo")
        all.emplace_back("rights::write");
    if (entry.mapping == "rpdo" || entry.mapping == "both")
        all.emplace_back("rights::rpdo");
    if (entry.mapping == "tpdo" || entry.mapping == "both")
        all.emplace_back("rights::tpdo");
    if (entry.stored)
        all.emplace_back("rights::stored");
    if (entry.node_id)
        all.emplace_back("rights::node_id");
    if (constant)
        all.emplace_back("rights::constant");
    return fmt::format("{}", fmt::join(all, " | "));
}

std::uint32_t limit_bits(const std::string& type, const Value& value) {
    if (type == "REAL32") {
        const auto* real = std::get_if<double>(&value);
        const auto narrow =
            static_cast<float>(real != nullptr ? *real : static_cast<double>(std::get<std::int64_t>(value)));
        std::uint32_t bits = 0;
        std::memcpy(&bits, &narrow, sizeof bits);
        return bits;
    }
    if (const auto* truth = std::get_if<bool>(&value))
        return *truth ? 1U : 0U;
    // As wide as the type: -1 of an INTEGER16 is FFFFh.
    const auto bits = static_cast<std::uint64_t>(std::get<std::int64_t>(value));
    const std::uint64_t mask = (std::uint64_t{1} << (8U * type_size(type))) - 1U;
    return static_cast<std::uint32_t>(bits & mask);
}

/// Rows of limits and allowed values, each written once however often it is used.
class LimitPool {
  public:
    /// Number of the row, or no_limit.
    std::string row_for(const Entry& entry) {
        if (entry.range.empty()) {
            return "no_limit";
        }
        std::string text;
        if (!entry.range.values.empty()) {
            text = fmt::format("{{{{LimitKind::list, 0x{:08X}U, 0}}, {{LimitKind::none, 0U, 0}}}}", list_for(entry));
        } else {
            text = fmt::format("{{{}, {}}}", limit(entry, entry.range.minimum), limit(entry, entry.range.maximum));
        }
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (rows[i] == text) {
                return fmt::format("{}U", i);
            }
        }
        rows.push_back(text);
        return fmt::format("{}U", rows.size() - 1);
    }

    std::vector<std::string> rows;
    std::vector<std::uint32_t> allowed;

  private:
    static std::string limit(const Entry& entry, const Limit& one) {
        if (one.kind == Limit::Kind::number) {
            return fmt::format("{{LimitKind::value, 0x{:08X}U, 0}}", limit_bits(entry.type, one.number));
        }
        if (one.kind == Limit::Kind::object) {
            const unsigned sub = one.subindex < 0 ? 0xFFU : static_cast<unsigned>(one.subindex);
            return fmt::format("{{LimitKind::entry, 0x{:08X}U, {}}}", (unsigned{one.index} << 8U) | sub, one.add);
        }
        return "{LimitKind::none, 0U, 0}";
    }

    std::uint32_t list_for(const Entry& entry) {
        std::vector<std::uint32_t> bits;
        for (const auto& value : entry.range.values) {
            bits.push_back(limit_bits(entry.type, value));
        }
        std::size_t first = 0;
        for (; first + bits.size() <= allowed.size(); ++first) {
            if (std::equal(bits.begin(), bits.end(), allowed.begin() + static_cast<std::ptrdiff_t>(first))) {
                break;
            }
        }
        if (first + bits.size() > allowed.size()) {
            first = allowed.size();
            allowed.insert(allowed.end(), bits.begin(), bits.end());
        }
        return static_cast<std::uint32_t>((first << 16U) | bits.size());
    }
};

/// One pool of values, a row an entry.
std::string value_pool(const std::string& name, const Part& part, const Layout& layout, bool constant) {
    const auto& pool = constant ? layout.constants : layout.image;
    std::string text = fmt::format("inline constexpr std::array<std::uint8_t, {}U> {}{{{{\n", pool.size(), name);
    for (std::size_t o = 0; o < part.objects.size(); ++o) {
        const Object& object = part.objects[o];
        for (std::size_t e = 0; e < object.entries.size(); ++e) {
            const Placement& place = layout.placements[o][e];
            if (place.constant != constant || place.size == 0) {
                continue;
            }
            text += "   ";
            for (std::size_t i = 0; i < place.size; ++i) {
                text += fmt::format(" 0x{:02X}U,", pool[place.offset + i]);
            }
            text += fmt::format("  // {}: {} {}\n", place.offset, object.id, object.entries[e].name);
        }
    }
    return text + "}};\n\n";
}

std::string string_rows(const std::string& type, const std::string& name, const std::vector<std::string>& rows) {
    std::string text = fmt::format("inline constexpr std::array<{}, {}U> {}{{{{\n", type, rows.size(), name);
    for (const auto& row : rows) {
        text += "    " + row + "\n";
    }
    return text + "}};\n\n";
}

bool has_field(const Entry& entry, const Placement& place) {
    return !place.constant && type_size(entry.type) > 0;
}

std::string field_for(const Object& object, const std::vector<Placement>& places) {
    std::string text;
    const std::string base = fmt::format("o{:04x}_{}", object.index, snake_case(object.name));
    if (object.kind == Object::Kind::array && object.entries.size() > 1 && has_field(object.entries[1], places[1])) {
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

}  // namespace

std::string write_objects(const Part& part) {
    const Layout layout = make_layout(part);
    LimitPool limits;
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
        for (std::size_t e = 0; e < object.entries.size(); ++e) {
            const Entry& entry = object.entries[e];
            const Placement& place = layout.placements[o][e];
            entries.push_back(fmt::format("{{{}U, {}U, {}, {}U, {}, {}, Service::{}}},  // {} {}", place.offset,
                                          place.size, limits.row_for(entry), entry.subindex, raw_type(entry.type),
                                          rights_of(entry, place.constant), entry.service, object.id, entry.name));
        }
        fields += field_for(object, layout.placements[o]);
    }
    std::vector<std::string> allowed;
    for (const auto bits : limits.allowed) {
        allowed.push_back(fmt::format("0x{:08X}U,", bits));
    }
    std::string text = heading(part);
    text += "#include <array>\n#include <cstdint>\n\n#include \"firmware/canopen/object_types.hpp\"\n\n";
    text += fmt::format("namespace canproof::generated::{} {{\n\n", part.cpp_name());
    text += string_rows("ObjectRow", "object_rows", objects);
    text += "// {offset, size, limit row, sub-index, type, rights, service}\n";
    text += string_rows("EntryRow", "entry_rows", entries);
    for (std::string& row : limits.rows) {
        row += ",";
    }
    text += string_rows("LimitRow", "limit_rows", limits.rows);
    text += string_rows("std::uint32_t", "allowed_values", allowed);
    text += value_pool("constant_pool", part, layout, true);
    text += value_pool("default_image", part, layout, false);
    text += fmt::format("inline constexpr std::size_t image_size = {}U;\n\n", layout.image.size());
    text += fmt::format(
        "inline constexpr DictionaryTables tables{{table_view(object_rows), table_view(entry_rows), "
        "table_view(limit_rows),\n"
        "    table_view(allowed_values), table_view(constant_pool), table_view(default_image), 0x{:08X}U}};\n\n",
        layout.fingerprint);
    text += "namespace field {\n" + fields + "}  // namespace field\n\n";
    return text + fmt::format("}}  // namespace canproof::generated::{}\n", part.cpp_name());
}

}  // namespace canproof::host
