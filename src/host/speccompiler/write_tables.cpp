#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "host/speccompiler/writers.hpp"

namespace canproof::host {

namespace {

std::string heading(const Part& part, const std::string& includes) {
    return fmt::format(
        "// Written by canproof's speccompiler from\n//   {}\n// Do not edit: change the register.\n#pragma "
        "once\n\n{}\n"
        "namespace canproof::generated::{} {{\n\n",
        fmt::join(part.files, "\n//   "), includes, part.cpp_name());
}

std::string ending(const Part& part) {
    return fmt::format("}}  // namespace canproof::generated::{}\n", part.cpp_name());
}

/// Narrowest unsigned (or 32-bit signed) type for a range.
std::string integer_type(std::int64_t low, std::int64_t high) {
    if (low < 0)
        return "std::int32_t";
    return high <= UINT8_MAX ? "std::uint8_t" : high <= UINT16_MAX ? "std::uint16_t" : "std::uint32_t";
}

std::string comment(const Item& item) {
    return item.text.empty() ? fmt::format("/// {} ({})\n", item.id, fmt::join(item.sources, ", "))
                             : fmt::format("/// {} ({}; {})\n", item.text, item.id, fmt::join(item.sources, ", "));
}

std::string whole_literal(std::int64_t value, const std::string& type) {
    if (type.find("uint") == std::string::npos)
        return fmt::format("{}", value);
    return value > 255 ? fmt::format("0x{:X}U", value) : fmt::format("{}U", value);
}

std::string real_literal(double value, bool narrow) {
    std::string text = fmt::format("{}", value);
    if (text.find_first_of(".e") == std::string::npos)
        text += ".0";
    return narrow ? text + "F" : text;
}

class TableWriter {
  public:
    TableWriter(const Register& content, const Part& part, const Table& table)
        : content_{content}, part_{part}, table_{table} {}

    std::string text() {
        std::string out = comment(table_);
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
                return integer_type(*column.minimum, *column.maximum);
            default:
                return enumeration_of(column);
        }
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
            words.push_back(snake_case(word));
        return fmt::format("enum class {} : std::uint8_t {{ {} }};\n", pascal_case(column.name),
                           fmt::join(words, ", "));
    }

    std::string literal(const Column& column, const Value& value) const {
        if (const auto* word = std::get_if<std::string>(&value))
            return enumeration_of(column) + "::" + snake_case(*word);
        if (const auto* truth = std::get_if<bool>(&value))
            return *truth ? "true" : "false";
        const std::string type = type_of(column);
        if (type == "float" || type == "double") {
            const auto* real = std::get_if<double>(&value);
            return real_literal(real != nullptr ? *real : static_cast<double>(std::get<std::int64_t>(value)),
                                type == "float");
        }
        return whole_literal(std::get<std::int64_t>(value), type);
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
                lines.push_back(
                    fmt::format("    {{{}{}}},  // line {}\n", head, fmt::join(outputs, ", "), row.place.line));
        }
        return fmt::format("inline constexpr std::array<Row, {}U> rows{{{{\n{}}}}};\n\n", lines.size(),
                           fmt::join(lines, ""));
    }

    std::string find() const {
        std::vector<std::string> parameters;
        std::vector<std::string> tests;
        for (const auto& column : table_.inputs) {
            parameters.push_back(fmt::format("const {} {}", type_of(column), column.name));
            tests.push_back(is_ranged(column)
                                ? fmt::format("(row.{0}_first <= {0}) && ({0} <= row.{0}_last)", column.name)
                                : fmt::format("(row.{0} == {0})", column.name));
        }
        return fmt::format(
            "/// The row for these inputs; nullptr outside the table's domain.\nconstexpr const Row* find({}) noexcept "
            "{{\n"
            "    for (const Row& row : rows) {{\n        if ({}) {{\n            return &row;\n        }}\n    }}\n    "
            "return nullptr;\n}}\n\n",
            fmt::join(parameters, ", "), fmt::join(tests, " && "));
    }

    const Register& content_;
    const Part& part_;
    const Table& table_;
};

}  // namespace

std::string write_tables(const Register& content, const Part& part) {
    std::string includes = "#include <array>\n#include <cstdint>\n\n#include \"generated/canopen/enumerations.hpp\"\n";
    if (part.is_device())
        includes += fmt::format("#include \"generated/{}/enumerations.hpp\"\n", part.cpp_name());
    std::string text = heading(part, includes);
    for (const auto& table : part.tables) {
        text += TableWriter{content, part, table}.text();
    }
    return text + ending(part);
}

std::string write_constants(const Part& part) {
    std::string text = heading(part, "#include <cstdint>\n");
    for (const auto& constant : part.constants) {
        const std::string type = cpp_type(constant.type);
        std::string value;
        if (type == "float" || type == "double") {
            const auto* real = std::get_if<double>(&constant.value);
            value = real_literal(real != nullptr ? *real : static_cast<double>(std::get<std::int64_t>(constant.value)),
                                 type == "float");
        } else {
            value = whole_literal(std::get<std::int64_t>(constant.value), type);
        }
        text += comment(constant);
        text += fmt::format("inline constexpr {} {}{{{}}};{}\n", type, constant.name, value,
                            constant.unit.empty() ? "" : "  // " + constant.unit);
    }
    return text + "\n" + ending(part);
}

std::string write_enumerations(const Part& part) {
    std::string text = heading(part, "#include <cstdint>\n");
    for (const auto& enumeration : part.enumerations) {
        std::int64_t high = 0;
        for (const auto& [word, number] : enumeration.values)
            high = std::max(high, number);
        const std::string type = integer_type(0, high);
        text += comment(enumeration);
        text += fmt::format("enum class {} : {} {{\n", enumeration.name, type);
        for (const auto& [word, number] : enumeration.values) {
            text += fmt::format("    {} = {},\n", snake_case(word),
                                high > UINT16_MAX ? fmt::format("0x{:08X}U", number) : whole_literal(number, type));
        }
        text += "};\n\n";
    }
    return text + ending(part);
}

std::string write_signals(const Part& part) {
    std::string text = heading(part, "#include <array>\n#include <cstdint>\n");
    for (const bool input : {true, false}) {
        text += input ? "/// What the physical world gives the device.\nstruct Inputs {\n"
                      : "/// What the device gives the physical world.\nstruct Outputs {\n";
        for (const auto& signal : part.signals) {
            if (signal.input != input)
                continue;
            const std::string type = cpp_type(signal.type);
            std::string name = signal.name;
            if (const auto at = name.find("{n}"); at != std::string::npos)
                name.erase(at, 3);
            std::string value = to_text(signal.value);
            if (type == "float" || type == "double") {
                const auto* real = std::get_if<double>(&signal.value);
                value =
                    real_literal(real != nullptr ? *real : static_cast<double>(std::get<std::int64_t>(signal.value)),
                                 type == "float");
            } else if (type != "bool") {
                value = whole_literal(std::get<std::int64_t>(signal.value), type);
            }
            const std::string what = fmt::format("  ///< {} {}({})", signal.text,
                                                 signal.unit.empty() ? "" : "[" + signal.unit + "] ", signal.id);
            text += signal.count > 1
                        ? fmt::format("    std::array<{}, {}U> {}{{}};{}\n", type, signal.count, name, what)
                        : fmt::format("    {} {}{{{}}};{}\n", type, name, value, what);
        }
        text += "};\n\n";
    }
    return text + ending(part);
}

std::string write_requirements(const Register& content) {
    std::string text =
        "// Written by canproof's speccompiler from spec/: every id of the register as a type, for implements<> and "
        "verifies<>.\n"
        "#pragma once\n\nnamespace canproof::req {\n\n";
    const auto add = [&](const std::string& id) {
        std::string name = id;
        std::replace(name.begin(), name.end(), '-', '_');
        text += fmt::format(
            "struct {0} {{ static constexpr bool in_force = true; static constexpr const char* id = \"{1}\"; }};\n",
            name, id);
    };
    for (const auto& part : content.parts) {
        std::set<std::string> retired;
        for (const auto& requirement : part.requirements) {
            if (!requirement.retired.empty())
                retired.insert(requirement.id);
        }
        content.for_each_item(part, [&](const Item& item, const char*) {
            if (retired.count(item.id) == 0)
                add(item.id);
        });
        for (const auto& decision : part.decisions)
            add(decision.id);
    }
    return text + "\n}  // namespace canproof::req\n";
}

std::string write_embedded(const SpecFiles& files) {
    // A string literal has a length limit: long files are written in pieces that the compiler joins at run time.
    constexpr std::size_t piece = 8000;
    std::string text =
        "// Written by canproof's speccompiler: the register's own files, so that the program needs no folder beside "
        "it.\n"
        "#include \"host/embedded_spec.hpp\"\n\nnamespace canproof::host {\n\nconst SpecFiles& embedded_spec() {\n    "
        "static const SpecFiles files{\n";
    for (const auto& [path, body] : files) {
        text += fmt::format("        {{\"{}\", std::string{{}}", path);
        for (std::size_t at = 0; at < body.size(); at += piece) {
            text += fmt::format(" +\n            std::string{{R\"~~~~({})~~~~\"}}", body.substr(at, piece));
        }
        text += "},\n";
    }
    return text + "    };\n    return files;\n}\n\n}  // namespace canproof::host\n";
}

}  // namespace canproof::host
