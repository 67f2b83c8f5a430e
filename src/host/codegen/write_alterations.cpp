// SPDX-License-Identifier: Apache-2.0
// Lists the generated cells with their altered values, for `canproof mutate`.
#include "host/codegen/write_alterations.hpp"

#include <fmt/format.h>

#include "host/base/one_line.hpp"
#include "host/codegen/cpp_text.hpp"
#include "host/codegen/dictionary_rows.hpp"
#include "host/codegen/table_code.hpp"
#include "host/register/alter_value.hpp"
#include "host/register/layout.hpp"
#include "host/register/literals.hpp"

namespace canproof::host {

namespace {

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : one_line(text)) {
        out += (c == '"' || c == '\\') ? std::string{'\\', c} : std::string{c};
    }
    return out + "\"";
}

/// Returns one row of the list of alterations. `target` is the C++ name of the altered value, and `bits` is a C++
/// expression for its new value.
std::string line(const std::string& id, const std::string& cell, const std::string& change, const std::string& target,
                 const std::string& size, const std::string& bits) {
    return fmt::format("    {{{}, {}, {}, &{}, {}, {}}},\n", quoted(id), quoted(cell), quoted(change), target, size,
                       bits);
}

std::string hex(std::uint64_t bits) {
    return fmt::format("0x{:X}U", bits);
}

std::string constants_of(const Part& part) {
    std::string out;
    for (const Constant& constant : part.constants) {
        const Value other = other_value(constant.value, constant.type);
        if (constant.compiled_in || std::holds_alternative<std::monostate>(other)) {
            continue;
        }
        const std::string target = part.cpp_name() + "::" + constant.name;
        out += line(constant.id, "value", to_text(constant.value) + " -> " + to_text(other), target,
                    fmt::format("sizeof({})", target), hex(bit_pattern(other, cpp_type(constant.type))));
    }
    return out;
}

/// Returns the CiA type that corresponds to the C++ type of a numeric column.
std::string number_type(const TableCode& code, const Column& column) {
    const std::string type = code.type_of(column);
    for (const char* word : {"BOOLEAN", "INTEGER8", "INTEGER16", "INTEGER32", "INTEGER64", "UNSIGNED8", "UNSIGNED16",
                             "UNSIGNED32", "UNSIGNED64", "REAL32", "REAL64"}) {
        if (cpp_type(word) == type) {
            return word;
        }
    }
    return "";
}

class TableAlterations {
  public:
    TableAlterations(const Register& content, const Part& part, const Table& table)
        : part_{part}, table_{table}, code_{content, part, table} {}

    std::string text() const {
        std::string out;
        const auto rows = code_.rows();
        for (std::size_t at = 0; at < rows.size(); ++at) {
            for (const RowField& field : rows[at]) {
                out += field_line(at, field);
            }
        }
        return out;
    }

  private:
    std::string field_line(std::size_t at, const RowField& field) const {
        const std::string space = part_.cpp_name() + "::" + code_.space();
        const std::string target = fmt::format("{}::rows[{}U].{}", space, at, field.name);
        const std::string size = fmt::format("sizeof({})", target);
        const std::string cell = fmt::format("row {} {}", at + 1, field.name);
        if (const auto* word = std::get_if<std::string>(&field.value)) {
            const auto other = other_word(*word, field.column->words);
            if (!other) {
                return "";
            }
            if (code_.is_errors(*field.column)) {
                const std::string where = is_node_error(*other) ? "canproof" : part_.cpp_name();
                return line(
                    table_.id, cell, *word + " -> " + *other, target, size,
                    fmt::format("static_cast<std::uint64_t>({}::{})", where, code_.literal(*field.column, *other)));
            }
            const std::string type = code_.enumeration_of(*field.column);
            const bool own = field.column->enumeration.empty();
            const bool shared = type.rfind("canopen::", 0) == 0;
            return line(table_.id, cell, *word + " -> " + *other, target, size,
                        fmt::format("static_cast<std::uint64_t>({}::{}::{})",
                                    own      ? space
                                    : shared ? "canproof::generated"
                                             : part_.cpp_name(),
                                    type, cpp_word(*other)));
        }
        const Value other = other_value(field.value, number_type(code_, *field.column));
        return line(table_.id, cell, to_text(field.value) + " -> " + to_text(other), target, size,
                    hex(bit_pattern(other, code_.type_of(*field.column))));
    }

    const Part& part_;
    const Table& table_;
    TableCode code_;
};

class ObjectAlterations {
  public:
    explicit ObjectAlterations(const Part& part)
        : part_{part}, space_{part.cpp_name()}, rows_{make_rows(part, Limits::one_an_entry)} {}

    std::string text() {
        for (std::size_t o = 0; o < part_.objects.size(); ++o) {
            object_ = &part_.objects[o];
            add("index", fmt::format("{:04X}h is missing", object_->index), fmt::format("object_rows[{}U].index", o),
                object_->index ^ 0x8000U);
            for (std::size_t e = 0; e < object_->entries.size(); ++e) {
                entry_ = &object_->entries[e];
                at_ = rows_.objects[o].first_entry + e;
                add_entry(rows_.layout.placements[o][e]);
            }
        }
        return out_;
    }

  private:
    void add(const std::string& cell, const std::string& change, const std::string& target, std::uint64_t bits) {
        const std::string full = space_ + "::" + target;
        out_ += line(object_->id, cell, change, full, fmt::format("sizeof({})", full), hex(bits));
    }
    std::string sub(const char* cell) const { return fmt::format("sub {} {}", entry_->subindex, cell); }
    std::string row(const char* member) const { return fmt::format("entry_rows[{}U].{}", at_, member); }

    void add_entry(const Placement& place) {
        const EntryRow& entry = rows_.entries[at_];
        add(sub("sub-index"), "is missing", row("subindex"), 0xF0U);
        add_type(entry);
        if (place.size > 0) {
            add_size(place);
            add_default(place);
        }
        add_rights(entry, place);
        if (entry.limit != no_limit) {
            add_limits(entry);
        }
    }

    /// Adds an alteration of the entry's type to another type of the same length, such as UNSIGNED8 to INTEGER8.
    void add_type(const EntryRow& entry) {
        static const std::pair<DataType, DataType> pairs[] = {
            {DataType::boolean, DataType::unsigned8},    {DataType::unsigned8, DataType::integer8},
            {DataType::integer8, DataType::unsigned8},   {DataType::unsigned16, DataType::integer16},
            {DataType::integer16, DataType::unsigned16}, {DataType::unsigned32, DataType::integer32},
            {DataType::integer32, DataType::unsigned32}, {DataType::real32, DataType::unsigned32},
            {DataType::unsigned64, DataType::integer64}, {DataType::integer64, DataType::unsigned64},
            {DataType::real64, DataType::unsigned64},    {DataType::visible_string, DataType::octet_string},
            {DataType::octet_string, DataType::domain},  {DataType::domain, DataType::octet_string},
        };
        for (const auto& [type, other] : pairs) {
            if (entry.type == type) {
                add(sub("type"),
                    fmt::format("{:02X}h -> {:02X}h", static_cast<unsigned>(type), static_cast<unsigned>(other)),
                    row("type"), static_cast<std::uint64_t>(other));
            }
        }
    }

    void add_size(const Placement& place) {
        const unsigned size = place.size;
        const unsigned other = is_string_type(entry_->type) ? size - 1U : size == 1U ? 2U : size / 2U;
        add(sub("length"), fmt::format("{} -> {}", size, other), row("size"), other);
    }

    void add_default(const Placement& place) {
        const std::string target =
            fmt::format("{}::{}[{}U]", space_, place.constant ? "constant_pool" : "default_image", place.offset);
        if (is_string_type(entry_->type)) {
            const auto first = static_cast<unsigned char>(value_bytes(*entry_, 1).front());
            out_ += line(object_->id, sub("default"), "first character", target, "1U", hex(first ^ 1U));
            return;
        }
        const Value other = other_value(entry_->value, entry_->type);
        out_ += line(object_->id, sub("default"), to_text(entry_->value) + " -> " + to_text(other), target,
                     fmt::format("{}U", place.size), hex(bit_pattern(other, cpp_type(entry_->type))));
    }

    void add_rights(const EntryRow& entry, const Placement& place) {
        const std::pair<std::uint8_t, const char*> all[] = {
            {rights::read, "readable"},     {rights::write, "writable"}, {rights::rpdo, "RPDO mapping"},
            {rights::tpdo, "TPDO mapping"}, {rights::stored, "stored"},  {rights::node_id, "node-ID added"}};
        for (const auto& [right, name] : all) {
            // The value of a constant entry is in flash, so it can be neither stored nor mapped to a PDO.
            const bool possible = !place.constant || right == rights::read || right == rights::write;
            if (possible) {
                add(sub(name), (entry.rights & right) != 0U ? "yes -> no" : "no -> yes", row("rights"),
                    static_cast<std::uint8_t>(entry.rights ^ right));
            }
        }
    }

    void add_limits(const EntryRow& entry) {
        const std::string target = fmt::format("limit_rows[{}U].", entry.limit);
        const LimitRow& limits = rows_.limits[entry.limit];
        if (limits.minimum.kind == LimitKind::list) {
            add_list(limits.minimum);
            return;
        }
        if (limits.minimum.kind == LimitKind::value_or_zero) {
            add(sub("zero allowed"), "yes -> no", target + "minimum.kind",
                static_cast<std::uint64_t>(LimitKind::value));
        }
        add_limit("minimum", entry_->range.minimum, limits.minimum, target + "minimum.");
        add_limit("maximum", entry_->range.maximum, limits.maximum, target + "maximum.");
    }

    void add_limit(const char* name, const Limit& limit, const canproof::Limit& row, const std::string& target) {
        const std::string type = cpp_type(entry_->type);
        for (const int step : {1, -1}) {
            if (limit.kind == Limit::Kind::object && !is_real_type(entry_->type)) {
                add(sub(name), fmt::format("{:04X}h {:+}", limit.index, step), target + "add",
                    static_cast<std::uint32_t>(row.add + step));
            } else if (const auto other = neighbour(limit.number, entry_->type, step)) {
                add(sub(name), to_text(limit.number) + " -> " + to_text(*other), target + "bits",
                    bit_pattern(*other, type) & 0xFFFFFFFFU);
            }
        }
        if (limit.kind == Limit::Kind::object) {
            add(sub(name), fmt::format("{:04X}h -> none", limit.index), target + "kind",
                static_cast<std::uint64_t>(LimitKind::none));
        }
    }

    void add_list(const canproof::Limit& list) {
        const std::size_t first = list.bits >> 16U;
        for (std::size_t i = 0; i < entry_->range.values.size(); ++i) {
            const Value& value = entry_->range.values[i];
            const Value other = other_value(value, entry_->type);
            add(sub("allowed value"), to_text(value) + " -> " + to_text(other),
                fmt::format("allowed_values[{}U]", first + i),
                bit_pattern(other, cpp_type(entry_->type)) & 0xFFFFFFFFU);
        }
    }

    const Part& part_;
    std::string space_;
    DictionaryRows rows_;
    const Object* object_{nullptr};
    const Entry* entry_{nullptr};
    std::size_t at_{0};
    std::string out_;
};

}  // namespace

std::string write_alterations(const Register& content) {
    std::string text = "// Written by canproof's speccompiler from spec/: how each cell is altered.\n";
    std::string body;
    for (const Part& part : content.parts) {
        for (const char* file : {"constants", "enumerations", "tables"}) {
            text += fmt::format("#include \"generated/{}/{}.hpp\"\n", part.cpp_name(), file);
        }
        body += constants_of(part);
        for (const Table& table : part.tables) {
            body += TableAlterations{content, part, table}.text();
        }
        if (part.is_device()) {
            text += fmt::format("#include \"generated/{}/objects.hpp\"\n", part.cpp_name());
            body += ObjectAlterations{part}.text();
        }
    }
    return text +
           "#include \"host/codegen/alteration.hpp\"\n\nnamespace canproof::host {\n\nnamespace {\n\n"
           "using namespace canproof::generated;\n\n// {item, cell, change, address, size, bits}\n"
           "const Alteration all[] = {\n" +
           body +
           "};\n\n}  // namespace\n\nAlterations generated_alterations() {\n    return {all, std::size(all)};\n}\n\n"
           "}  // namespace canproof::host\n";
}

}  // namespace canproof::host
