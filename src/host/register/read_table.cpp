// SPDX-License-Identifier: Apache-2.0
#include "host/register/read_table.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "host/register/read_item.hpp"

namespace canproof::host {

namespace {

Column read_column(const toml::node& node, TomlItem& table) {
    Column column;
    column.place = {table.file(), static_cast<unsigned>(node.source().begin.line)};
    if (const auto name = node.as_string()) {
        column.name = name->get();
        return column;
    }
    const auto fields = node.as_table();
    if (fields == nullptr) {
        table.fault("a column is neither a name nor a table", "write \"name\" or { name = \"…\", min = 0, max = 15 }");
        return column;
    }
    TomlItem item{*fields, table.file(), table.faults()};
    column.name = item.text("name");
    column.enumeration = item.text_or("enumeration", "");
    column.type = item.text_or("type", "");
    column.unit = item.text_or("unit", "");
    column.words = item.texts("values", false);
    if (item.has("min") || item.has("max")) {
        column.minimum = item.integer("min", INT32_MIN, INT64_MAX);
        column.maximum = item.integer("max", *column.minimum, INT64_MAX);
    }
    item.finish();
    return column;
}

std::vector<Column> read_columns(TomlItem& item, const std::string& key) {
    std::vector<Column> columns;
    const toml::node* node = item.node(key);
    const auto list = node == nullptr ? nullptr : node->as_array();
    if (list == nullptr || list->empty()) {
        item.fault(fmt::format("the table has no {}", key), fmt::format("add `{} = [ … ]`", key));
        return columns;
    }
    for (const auto& one : *list) {
        columns.push_back(read_column(one, item));
    }
    return columns;
}

std::optional<std::int64_t> to_number(const std::string& digits) {
    std::int64_t number = 0;
    const char* const end = digits.data() + digits.size();
    const auto [rest, error] = std::from_chars(digits.data(), end, number);
    return error == std::errc{} && rest == end ? std::optional{number} : std::nullopt;
}

Cell::Part read_part(const toml::node& node) {
    const Value value = literal(node);
    const auto* text = std::get_if<std::string>(&value);
    const auto dots = text == nullptr ? std::string::npos : text->find("..");
    if (dots != std::string::npos) {
        const auto first = to_number(text->substr(0, dots));
        const auto last = to_number(text->substr(dots + 2));
        if (first && last) {
            return {*first, *last};
        }
    }
    return {value, value, is_hexadecimal(node)};
}

Cell read_cell(const toml::node& node) {
    Cell cell;
    if (const auto list = node.as_array()) {
        for (const auto& one : *list) {
            cell.parts.push_back(read_part(one));
        }
        if (list->empty()) {
            // an empty list: the added part has no value, which the check of the column's domain reports
            cell.parts.push_back({});
        }
    } else if (const auto text = node.as_string(); text == nullptr || text->get() != "*") {
        cell.parts.push_back(read_part(node));
    }
    return cell;
}

/// Determines the kind of a column (words, integers …) from its cells. If the column has no words or limits of its own,
/// takes them from the cells as well.
void infer(Column& column, const Table& table, std::size_t at) {
    bool words = !column.words.empty() || !column.enumeration.empty();
    bool booleans = false;
    bool reals = column.type == "REAL32" || column.type == "REAL64";
    const bool collect = column.words.empty();
    std::set<std::string> collected;
    std::optional<std::int64_t> low;
    std::optional<std::int64_t> high;
    for (const auto& row : table.rows) {
        if (at >= row.cells.size()) {
            continue;
        }
        for (const auto& part : row.cells[at].parts) {
            if (const auto* text = std::get_if<std::string>(&part.first)) {
                words = true;
                if (collect && collected.insert(*text).second) {
                    column.words.push_back(*text);
                }
            }
            booleans = booleans || std::holds_alternative<bool>(part.first);
            reals = reals || std::holds_alternative<double>(part.first);
            if (const auto* first = std::get_if<std::int64_t>(&part.first)) {
                const auto* last = std::get_if<std::int64_t>(&part.last);
                low = std::min(low.value_or(*first), *first);
                high = std::max(high.value_or(*last), *last);
            }
        }
    }
    column.kind = words      ? Column::Kind::words
                  : booleans ? Column::Kind::booleans
                  : reals    ? Column::Kind::reals
                             : Column::Kind::integers;
    if (column.kind == Column::Kind::integers && !column.minimum) {
        column.minimum = low.value_or(0);
        column.maximum = high.value_or(0);
    }
}

}  // namespace

Table read_table(TomlItem& item) {
    Table table;
    read_common(item, table, false);
    read_id(item, table);
    table.text = item.text("title");
    table.name = item.text_or("name", snake_case(table.text.substr(0, table.text.find_first_of(",:;("))));
    table.errors = item.text_or("errors", "");
    table.inputs = read_columns(item, "inputs");
    table.outputs = read_columns(item, "outputs");
    const std::size_t width = table.inputs.size() + table.outputs.size();
    const toml::node* node = item.node("rows");
    const auto rows = node == nullptr ? nullptr : node->as_array();
    if (rows == nullptr || rows->empty()) {
        item.fault("the table has no rows", "add `rows = [ [ … ], … ]`");
        table.complete = false;
    } else {
        for (const auto& one : *rows) {
            Table::Row row;
            row.place = {item.file(), static_cast<unsigned>(one.source().begin.line)};
            const auto cells = one.as_array();
            if (cells == nullptr || cells->size() != width) {
                item.fault(row.place,
                           fmt::format("row of {} has {} cells", table.id, cells == nullptr ? 0 : cells->size()),
                           fmt::format("write {} cells: one for each input and output", width));
                table.complete = false;
                continue;
            }
            for (const auto& cell : *cells) {
                row.cells.push_back(read_cell(cell));
            }
            table.rows.push_back(row);
        }
    }
    for (std::size_t i = 0; i < table.inputs.size(); ++i) {
        infer(table.inputs[i], table, i);
    }
    for (std::size_t i = 0; i < table.outputs.size(); ++i) {
        infer(table.outputs[i], table, table.inputs.size() + i);
    }
    item.finish();
    return table;
}

}  // namespace canproof::host
