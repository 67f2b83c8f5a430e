#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host/speccompiler/literals.hpp"
#include "host/speccompiler/writers.hpp"

namespace canproof::host {

namespace {

class TableWriter {
  public:
    TableWriter(const Register& content, const Part& part, const Table& table)
        : content_{content}, part_{part}, table_{table} {}

    std::string text() {
        std::string out = item_comment(table_, "");
        out += fmt::format("namespace t_{} {{\n\n", snake_case(table_.id));
        for (const auto* columns : {&table_.inputs, &table_.outputs}) {
            for (const auto& column : *columns) {
                if (column.kind == Column::Kind::words && column.enumeration.empty()) {
                    out += own_enumeration(column);
                }
            }
        }
        out += "struct Row {\n";
        for (const auto& column : table_.inputs) {
            if (is_ranged(column)) {
                out += fmt::format("    {0} {1}_first;\n    {0} {1}_last;\n", type_of(column), column.name);
            } else {
                out += fmt::format("    {} {};\n", type_of(column), column.name);
            }
        }
        for (const auto& column : table_.outputs) {
            out += fmt::format("    {} {};{}\n", type_of(column), column.name,
                               column.unit.empty() ? "" : "  ///< " + column.unit);
        }
        out += "};\n\n" + rows() + find();
        return out + fmt::format("}}  // namespace t_{}\n\n", snake_case(table_.id));
    }

  private:
    bool is_ranged(const Column& column) const {
        return column.kind == Column::Kind::integers &&
               std::any_of(table_.rows.begin(), table_.rows.end(), [&](const Table::Row& row) {
                   const Cell& cell = row.cells[position(column)];
                   return cell.any() || std::any_of(cell.parts.begin(), cell.parts.end(),
                                                    [](const Cell::Part& p) { return p.first != p.last; });
               });
    }

    std::size_t position(const Column& column) const {
        return static_cast<std::size_t>(&column - table_.inputs.data());
    }

    std::string type_of(const Column& column) const {
        if (!column.type.empty())
            return cpp_type(column.type);
        switch (column.kind) {
            case Column::Kind::booleans:
                return "bool";
            case Column::Kind::reals:
                return "float";
            case Column::Kind::integers:
                return cpp_integer_type(*column.minimum, *column.maximum);
            default:
                return enumeration_of(column);
        }
    }

    /// Two narrow operands would both become int, and change their sign (MISRA C++:2023 7.0.5).
    std::string wide_type_of(const Column& column) const {
        const std::string type = type_of(column);
        return (type == "std::uint8_t" || type == "std::uint16_t") ? "std::uint32_t" : type;
    }

    std::string enumeration_of(const Column& column) const {
        if (column.enumeration.empty())
            return pascal_case(column.name);
        const Enumeration* found = content_.enumeration(part_, column.enumeration);
        const bool shared = found->id.rfind("CO-", 0) == 0 && part_.is_device();
        return (shared ? "canopen::" : "") + found->name;
    }

    static std::string own_enumeration(const Column& column) {
        std::vector<std::string> words;
        for (const auto& word : column.words)
            words.push_back(cpp_word(word));
        return fmt::format("enum class {} : std::uint8_t {{ {} }};\n", pascal_case(column.name),
                           fmt::join(words, ", "));
    }

    std::string literal(const Column& column, const Value& value) const {
        if (const auto* word = std::get_if<std::string>(&value)) {
            return enumeration_of(column) + "::" + cpp_word(*word);
        }
        return cpp_literal(value, type_of(column));
    }

    /// The ways to write one input cell: "*" and alternatives become one row each, an integer range a pair.
    std::vector<std::string> choices(const Column& column, const Cell& cell) const {
        std::vector<std::string> all;
        if (column.kind == Column::Kind::integers) {
            std::vector<Cell::Part> parts = cell.parts;
            if (cell.any())
                parts.push_back({*column.minimum, *column.maximum});
            for (const auto& part : parts) {
                all.push_back(is_ranged(column) ? literal(column, part.first) + ", " + literal(column, part.last)
                                                : literal(column, part.first));
            }
            return all;
        }
        std::vector<Value> values;
        for (const auto& part : cell.parts)
            values.push_back(part.first);
        if (cell.any() && column.kind == Column::Kind::booleans)
            values = {false, true};
        if (cell.any() && column.kind == Column::Kind::words)
            values.assign(column.words.begin(), column.words.end());
        for (const auto& value : values)
            all.push_back(literal(column, value));
        return all;
    }

    std::string rows() const {
        std::vector<std::string> lines;
        for (const auto& row : table_.rows) {
            std::vector<std::string> heads{""};
            for (std::size_t i = 0; i < table_.inputs.size(); ++i) {
                std::vector<std::string> longer;
                for (const auto& head : heads) {
                    for (const auto& choice : choices(table_.inputs[i], row.cells[i]))
                        longer.push_back(head + choice + ", ");
                }
                heads = longer;
            }
            std::vector<std::string> outputs;
            for (std::size_t i = 0; i < table_.outputs.size(); ++i) {
                outputs.push_back(literal(table_.outputs[i], row.cells[table_.inputs.size() + i].parts.front().first));
            }
            for (const auto& head : heads)
                lines.push_back(fmt::format("    {{{}{}}},  // {}\n", head, fmt::join(outputs, ", "), table_.id));
        }
        return fmt::format("inline constexpr std::array<Row, {}U> rows{{{{\n{}}}}};\n\n", lines.size(),
                           fmt::join(lines, ""));
    }

    std::string find() const {
        std::vector<std::string> parameters;
        std::vector<std::string> tests;
        std::vector<std::string> firsts;
        std::vector<std::string> lasts;
        for (const auto& column : table_.inputs) {
            const std::string name = "row." + column.name;
            firsts.push_back(is_ranged(column) ? name + "_first" : name);
            lasts.push_back(is_ranged(column) ? name + "_last" : name);
            parameters.push_back(fmt::format("const {} {}", wide_type_of(column), column.name));
            tests.push_back(is_ranged(column)
                                ? fmt::format("(row.{0}_first <= {0}) && ({0} <= row.{0}_last)", column.name)
                                : fmt::format("(row.{0} == {0})", column.name));
        }
        std::string hidden = fmt::format("find({}) != &row", fmt::join(firsts, ", "));
        if (firsts != lasts) {
            hidden = fmt::format("({}) || (find({}) != &row)", hidden, fmt::join(lasts, ", "));
        }
        return fmt::format(
            "/// The row for these inputs; nullptr outside the table's domain.\nconstexpr const Row* find({}) noexcept "
            "{{\n"
            "    for (const Row& row : rows) {{\n        if ({}) {{\n            return &row;\n        }}\n    }}\n    "
            "return nullptr;\n}}\n\n"
            "/// No row hides another.\nconstexpr bool finds_each_row() noexcept {{\n"
            "    for (const Row& row : rows) {{\n        if ({}) {{\n"
            "            return false;\n        }}\n    }}\n    return true;\n}}\n"
            "static_assert(finds_each_row());\n\n",
            fmt::join(parameters, ", "), fmt::join(tests, " && "), hidden);
    }

    const Register& content_;
    const Part& part_;
    const Table& table_;
};

}  // namespace

std::string write_tables(const Register& content, const Part& part) {
    std::string text = heading(part);
    text += "#include <array>\n#include <cstdint>\n\n#include \"generated/canopen/enumerations.hpp\"\n";
    if (part.is_device()) {
        text += fmt::format("#include \"generated/{}/enumerations.hpp\"\n", part.cpp_name());
    }
    text += fmt::format("\nnamespace canproof::generated::{} {{\n\n", part.cpp_name());
    for (const auto& table : part.tables) {
        text += TableWriter{content, part, table}.text();
    }
    return text + fmt::format("}}  // namespace canproof::generated::{}\n", part.cpp_name());
}

}  // namespace canproof::host
