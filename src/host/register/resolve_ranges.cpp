// SPDX-License-Identifier: Apache-2.0
// Resolves `range = { table = … }`: copies the values of the table's first input column to the entry.
#include "host/register/resolve_ranges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

namespace canproof::host {

namespace {

/// Greatest difference between the ends of a range in a table cell. A table with a longer range cannot determine the
/// allowed values of an object.
constexpr std::uint64_t most_values = 0x10000;

/// Returns the difference `high` - `low`, which may be greater than an int64_t. `low` must not exceed `high`.
std::uint64_t difference(std::int64_t low, std::int64_t high) {
    return static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low);
}

const Table* find_table(const Register& content, const Part& part, const std::string& id) {
    for (const Part* place : {&part, content.part("canopen")}) {
        if (place == nullptr) {
            continue;
        }
        const auto found =
            std::find_if(place->tables.begin(), place->tables.end(), [&](const Table& t) { return t.id == id; });
        if (found != place->tables.end()) {
            return &*found;
        }
    }
    return nullptr;
}

bool add_cell(std::set<std::int64_t>& numbers, const Column& column, const Cell& cell) {
    std::vector<Cell::Part> parts = cell.parts;
    if (cell.any() && column.minimum && column.maximum) {
        parts.emplace_back();
        parts.back().first = *column.minimum;
        parts.back().last = *column.maximum;
    }
    for (const auto& part : parts) {
        const auto* first = std::get_if<std::int64_t>(&part.first);
        const auto* last = std::get_if<std::int64_t>(&part.last);
        if (first == nullptr || last == nullptr || *last < *first) {
            continue;
        }
        const std::uint64_t length = difference(*first, *last);
        if (length > most_values) {
            return false;
        }
        for (std::uint64_t i = 0; i <= length; ++i) {
            numbers.insert(*first + static_cast<std::int64_t>(i));
        }
    }
    return true;
}

/// Returns the numbers in a table's first input column. For a column with an enumeration, returns all numbers of the
/// enumeration. Returns nothing when a cell has a range that is too long.
std::optional<std::set<std::int64_t>> numbers_of(const Register& content, const Part& part, const Table& table) {
    std::set<std::int64_t> numbers;
    if (table.inputs.empty()) {
        return numbers;
    }
    const Column& column = table.inputs.front();
    if (const Enumeration* words = content.enumeration(part, column.enumeration)) {
        for (const auto& [word, number] : words->values) {
            numbers.insert(number);
        }
        return numbers;
    }
    for (const auto& row : table.rows) {
        if (!add_cell(numbers, column, row.cells.front())) {
            return std::nullopt;
        }
    }
    return numbers;
}

/// Stores the numbers in `range`: as minimum and maximum if they have no gap, otherwise as a list.
void put(const std::set<std::int64_t>& numbers, Range& range) {
    const std::int64_t low = *numbers.begin();
    const std::int64_t high = *numbers.rbegin();
    if (difference(low, high) == numbers.size() - 1) {
        range.minimum = Limit{Limit::Kind::number, low, 0, -1, 0, range.place};
        range.maximum = Limit{Limit::Kind::number, high, 0, -1, 0, range.place};
    } else {
        range.values.assign(numbers.begin(), numbers.end());
    }
}

}  // namespace

void resolve_ranges(const Register& content, Part& part, Faults& faults) {
    for (Object& object : part.objects) {
        for (Entry& entry : object.entries) {
            Range& range = entry.range;
            if (range.table.empty()) {
                continue;
            }
            const Table* table = find_table(content, part, range.table);
            if (table == nullptr) {
                faults.push_back({range.place,
                                  fmt::format("{:04X}h:{} takes its range from table {}, which does not exist",
                                              object.index, entry.subindex, range.table),
                                  "name a [[table]] of this device or of spec/canopen"});
                continue;
            }
            const auto numbers = numbers_of(content, part, *table);
            if (!numbers) {
                faults.push_back(
                    {range.place,
                     fmt::format("table {} has a range of more than {} numbers", range.table, most_values + 1),
                     "write the range of the object as `min` and `max`"});
                continue;
            }
            if (numbers->empty()) {
                faults.push_back({range.place, fmt::format("table {} has no numbers in its first column", range.table),
                                  "name a table whose first input is a number"});
                continue;
            }
            put(*numbers, range);
        }
    }
}

}  // namespace canproof::host
