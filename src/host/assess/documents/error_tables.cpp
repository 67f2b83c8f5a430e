// SPDX-License-Identifier: Apache-2.0
#include "host/assess/documents/error_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/assess/documents/item_words.hpp"

namespace canproof::host {

namespace {

/// Returns the number that the column's enumeration gives to the word `value`. Returns `value` itself when it is no
/// such word.
Value number_in(const Register& content, const Part& part, const Column& column, const Value& value) {
    const auto* word = std::get_if<std::string>(&value);
    const Enumeration* enumeration =
        column.enumeration.empty() ? nullptr : content.enumeration(part, column.enumeration);
    if (word == nullptr || enumeration == nullptr) {
        return value;
    }
    const auto found = std::find_if(enumeration->values.begin(), enumeration->values.end(),
                                    [word](const auto& one) { return one.first == *word; });
    return found == enumeration->values.end() ? value : Value{found->second};
}

std::string hexadecimal(const Value& value, const int digits) {
    const auto* number = std::get_if<std::int64_t>(&value);
    return number == nullptr ? to_text(value) : fmt::format("{:0{}X}h", *number, digits);
}

std::string field_words(const Register& content, const Part& part, const Column& column, const Cell& cell) {
    if (cell.parts.size() != 1) {
        return cell_words(cell);
    }
    const Value& value = cell.parts.front().first;
    const Value number = number_in(content, part, column, value);
    return number == value ? cell_words(cell) : fmt::format("{} ({})", to_text(value), hexadecimal(number, 2));
}

ErrorRow row_of(const Register& content, const Part& part, const Table& table, const Table::Row& row) {
    constexpr int code_digits = 4;
    ErrorRow made{table.id, "", "", {}};
    for (std::size_t at = 0; at < row.cells.size(); ++at) {
        const bool input = at < table.inputs.size();
        const Column& column = input ? table.inputs[at] : table.outputs.at(at - table.inputs.size());
        const Cell& cell = row.cells[at];
        if (column.name == table.errors) {
            made.error = cell_words(cell);
        } else if (column.name == "code" && cell.parts.size() == 1) {
            made.code = hexadecimal(number_in(content, part, column, cell.parts.front().first), code_digits);
        } else {
            made.others.emplace_back(column.name, field_words(content, part, column, cell));
        }
    }
    return made;
}

}  // namespace

std::vector<ErrorRow> errors_of(const Register& content, const Part& part) {
    std::vector<ErrorRow> all;
    for (const auto& table : part.tables) {
        if (!table.errors.empty()) {
            for (const auto& row : table.rows) {
                all.push_back(row_of(content, part, table, row));
            }
        }
    }
    return all;
}

}  // namespace canproof::host
