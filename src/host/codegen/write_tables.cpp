// SPDX-License-Identifier: Apache-2.0
#include "host/codegen/write_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host/codegen/cpp_text.hpp"
#include "host/codegen/table_code.hpp"
#include "host/register/literals.hpp"

namespace canproof::host {

namespace {

std::string own_enumeration(const Column& column) {
    std::vector<std::string> words;
    for (const auto& word : column.words) {
        words.push_back(cpp_word(word));
    }
    return fmt::format("enum class {} : std::uint8_t {{ {} }};\n", pascal_case(column.name), fmt::join(words, ", "));
}

/// Returns an alias with the column's name for the enumeration of a column. Returns an empty text when the enumeration
/// has this name itself.
std::string alias_of(const TableCode& code, const Column& column) {
    const std::string name = pascal_case(column.name);
    return code.enumeration_of(column) == name ? ""
                                               : fmt::format("using {} = {};\n", name, code.enumeration_of(column));
}

std::string row_type(const TableCode& code, const Table& table) {
    std::string out = "struct Row {\n";
    for (const auto& column : table.inputs) {
        if (code.is_ranged(column)) {
            out += fmt::format("    {0} {1}_first;\n    {0} {1}_last;\n", code.type_of(column), column.name);
        } else {
            out += fmt::format("    {} {};\n", code.type_of(column), column.name);
        }
    }
    for (const auto& column : table.outputs) {
        out += fmt::format("    {} {};{}\n", code.type_of(column), column.name,
                           column.unit.empty() ? "" : "  ///< " + column.unit);
    }
    return out + "};\n\n";
}

std::string rows_of(const TableCode& code, const Table& table, Cells cells) {
    std::string lines;
    const auto rows = code.rows();
    for (const auto& row : rows) {
        std::vector<std::string> literals;
        for (const auto& field : row) {
            literals.push_back(code.literal(*field.column, field.value, field.hexadecimal));
        }
        lines += fmt::format("    {{{}}},  // {}\n", fmt::join(literals, ", "), table.id);
    }
    return fmt::format("{} std::array<Row, {}U> rows{{{{\n{}}}}};\n\n", storage_words(cells), rows.size(), lines);
}

/// Returns the C++ type of a column; an unsigned type has at least 32 bits. Narrower operands would be promoted to int,
/// which changes their signedness (MISRA C++:2023 7.0.5).
std::string wide_type_of(const TableCode& code, const Column& column) {
    const std::string type = code.type_of(column);
    return (type == "std::uint8_t" || type == "std::uint16_t") ? "std::uint32_t" : type;
}

/// Returns a static_assert for the generated code: for each row, a lookup with the inputs of this row finds this row.
std::string row_check(const TableCode& code, const Table& table) {
    std::vector<std::string> firsts;
    std::vector<std::string> lasts;
    for (const auto& column : table.inputs) {
        const std::string name = "row." + column.name;
        firsts.push_back(code.is_ranged(column) ? name + "_first" : name);
        lasts.push_back(code.is_ranged(column) ? name + "_last" : name);
    }
    std::string hidden = fmt::format("find({}) != &row", fmt::join(firsts, ", "));
    if (firsts != lasts) {
        hidden = fmt::format("({}) || (find({}) != &row)", hidden, fmt::join(lasts, ", "));
    }
    return fmt::format(
        "/// Returns whether the lookup finds each row.\nconstexpr bool finds_each_row() noexcept {{\n"
        "    for (const Row& row : rows) {{\n        if ({}) {{\n"
        "            return false;\n        }}\n    }}\n    return true;\n}}\n"
        "static_assert(finds_each_row());\n\n",
        hidden);
}

std::string find_in(const TableCode& code, const Table& table, Cells cells) {
    std::vector<std::string> parameters;
    std::vector<std::string> tests;
    for (const auto& column : table.inputs) {
        parameters.push_back(fmt::format("const {} {}", wide_type_of(code, column), column.name));
        tests.push_back(code.is_ranged(column)
                            ? fmt::format("(row.{0}_first <= {0}) && ({0} <= row.{0}_last)", column.name)
                            : fmt::format("(row.{0} == {0})", column.name));
    }
    return fmt::format(
        "/// Returns the row for these inputs; nullptr outside the table's domain.\n{} const Row* find({}) noexcept "
        "{{\n"
        "    for (const Row& row : rows) {{\n        if ({}) {{\n            return &row;\n        }}\n    }}\n    "
        "return nullptr;\n}}\n\n{}",
        cells == Cells::constant ? "constexpr" : "inline", fmt::join(parameters, ", "), fmt::join(tests, " && "),
        cells == Cells::constant ? row_check(code, table) : "");
}

std::string table_text(const Register& content, const Part& part, const Table& table, Cells cells) {
    const TableCode code{content, part, table};
    std::string out = item_comment(table, "");
    out += fmt::format("namespace {} {{\n\n", code.space());
    for (const auto* columns : {&table.inputs, &table.outputs}) {
        for (const auto& column : *columns) {
            if (column.kind == Column::Kind::words && !code.is_errors(column)) {
                out += column.enumeration.empty() ? own_enumeration(column) : alias_of(code, column);
            }
        }
    }
    out += row_type(code, table) + rows_of(code, table, cells) + find_in(code, table, cells);
    return out + fmt::format("}}  // namespace {}\n\n", code.space());
}

/// Returns a constant for each error of the device; their numbers follow those of the errors that every node has.
std::string error_names(const Part& part) {
    const auto words = own_errors(part);
    if (words.empty()) {
        return "";
    }
    std::string text =
        "/// Errors of this device; their numbers follow those of the errors of every node.\nnamespace error {\n";
    for (std::size_t i = 0; i < words.size(); ++i) {
        text += fmt::format("inline constexpr ErrorId {} = error_after(ErrorId::first_of_device, {}U);\n",
                            cpp_word(words[i]), i);
    }
    return text +
           fmt::format("static_assert(static_cast<std::size_t>(error::{}) < max_errors);\n}}  // namespace error\n\n",
                       cpp_word(words.back()));
}

}  // namespace

std::string write_tables(const Register& content, const Part& part, Cells cells) {
    std::string text = heading(part);
    text += "#include <array>\n#include <cstdint>\n\n#include \"generated/canopen/enumerations.hpp\"\n";
    if (part.is_device()) {
        text += fmt::format("#include \"generated/{}/enumerations.hpp\"\n", part.cpp_name());
    }
    const bool names_errors =
        std::any_of(part.tables.begin(), part.tables.end(), [](const Table& table) { return !table.errors.empty(); });
    text += names_errors ? "#include \"firmware/canopen/error_table.hpp\"\n" : "";
    text += fmt::format("\nnamespace canproof::generated::{} {{\n\n", part.cpp_name());
    text += error_names(part);
    for (const auto& table : part.tables) {
        text += table_text(content, part, table, cells);
    }
    return text + fmt::format("}}  // namespace canproof::generated::{}\n", part.cpp_name());
}

}  // namespace canproof::host
