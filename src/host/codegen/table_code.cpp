// SPDX-License-Identifier: Apache-2.0
#include "host/codegen/table_code.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "host/codegen/cpp_text.hpp"
#include "host/register/literals.hpp"

namespace canproof::host {

bool is_node_error(const std::string& word) {
    static const std::set<std::string> words{"can_overrun",       "error_passive", "guard_or_heartbeat",
                                             "bus_off_recovered", "sync_length",   "stored_set_checksum",
                                             "internal_software", "rpdo_length",   "rpdo_timeout",
                                             "life_guarding",     "heartbeat",     "rpdo_value"};
    return words.count(cpp_word(word)) != 0;
}

std::vector<std::string> own_errors(const Part& part) {
    std::vector<std::string> words;
    for (const Table& table : part.tables) {
        for (const Column& column : table.inputs) {
            if (table.errors.empty() || column.name != table.errors) {
                continue;
            }
            std::copy_if(column.words.begin(), column.words.end(), std::back_inserter(words), [&](const auto& word) {
                return !is_node_error(word) && std::find(words.begin(), words.end(), word) == words.end();
            });
        }
    }
    return words;
}

bool TableCode::is_ranged(const Column& column) const {
    return column.kind == Column::Kind::integers &&
           std::any_of(table_.rows.begin(), table_.rows.end(), [&](const Table::Row& row) {
               const Cell& cell = row.cells[position(column)];
               return cell.any() || std::any_of(cell.parts.begin(), cell.parts.end(),
                                                [](const Cell::Part& p) { return p.first != p.last; });
           });
}

std::size_t TableCode::position(const Column& column) const {
    return static_cast<std::size_t>(&column - table_.inputs.data());
}

std::string TableCode::type_of(const Column& column) const {
    if (!column.type.empty()) {
        return cpp_type(column.type);
    }
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

std::string TableCode::enumeration_of(const Column& column) const {
    if (is_errors(column)) {
        return "ErrorId";
    }
    if (column.enumeration.empty()) {
        return pascal_case(column.name);
    }
    const Enumeration* found = content_.enumeration(part_, column.enumeration);
    const bool shared = found->id.rfind("CO-", 0) == 0 && part_.is_device();
    return (shared ? "canopen::" : "") + found->name;
}

std::string TableCode::literal(const Column& column, const Value& value, bool hexadecimal) const {
    if (const auto* word = std::get_if<std::string>(&value)) {
        if (is_errors(column) && !is_node_error(*word)) {
            return "error::" + cpp_word(*word);
        }
        return enumeration_of(column) + "::" + cpp_word(*word);
    }
    return cpp_literal(value, type_of(column), hexadecimal);
}

std::vector<FieldRow> TableCode::choices(std::size_t input, std::size_t row) const {
    const Column& column = table_.inputs[input];
    const Cell& cell = table_.rows[row].cells[input];
    std::vector<FieldRow> all;
    if (column.kind == Column::Kind::integers) {
        std::vector<Cell::Part> parts = cell.parts;
        if (cell.any()) {
            parts.push_back({*column.minimum, *column.maximum});
        }
        for (const auto& part : parts) {
            all.push_back(is_ranged(column)
                              ? FieldRow{{column.name + "_first", &column, part.first, part.hexadecimal, row},
                                         {column.name + "_last", &column, part.last, part.hexadecimal, row}}
                              : FieldRow{{column.name, &column, part.first, part.hexadecimal, row}});
        }
        return all;
    }
    std::vector<Value> values;
    for (const auto& part : cell.parts) {
        values.push_back(part.first);
    }
    if (cell.any() && column.kind == Column::Kind::booleans) {
        values = {false, true};
    }
    if (cell.any() && column.kind == Column::Kind::words) {
        values.assign(column.words.begin(), column.words.end());
    }
    for (const auto& value : values) {
        all.push_back({{column.name, &column, value, false, row}});
    }
    return all;
}

std::vector<FieldRow> TableCode::rows() const {
    std::vector<FieldRow> all;
    for (std::size_t at = 0; at < table_.rows.size(); ++at) {
        std::vector<FieldRow> heads(1);
        for (std::size_t i = 0; i < table_.inputs.size(); ++i) {
            std::vector<FieldRow> longer;
            for (const auto& head : heads) {
                for (const auto& choice : choices(i, at)) {
                    longer.push_back(head);
                    longer.back().insert(longer.back().end(), choice.begin(), choice.end());
                }
            }
            heads = longer;
        }
        for (auto& head : heads) {
            for (std::size_t i = 0; i < table_.outputs.size(); ++i) {
                const Cell& cell = table_.rows[at].cells[table_.inputs.size() + i];
                const Cell::Part& part = cell.parts.front();
                head.push_back({table_.outputs[i].name, &table_.outputs[i], part.first, part.hexadecimal, at});
            }
            all.push_back(head);
        }
    }
    return all;
}

}  // namespace canproof::host
