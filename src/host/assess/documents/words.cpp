// SPDX-License-Identifier: Apache-2.0
#include "host/assess/documents/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace canproof::host {

namespace {

void add_numbers(const Table& table, const std::size_t column, std::set<std::int64_t>& into) {
    for (const auto& row : table.rows) {
        for (const auto& part : row.cells.at(column).parts) {
            if (const auto* number = std::get_if<std::int64_t>(&part.first)) {
                into.insert(*number);
            }
        }
    }
}

}  // namespace

std::string joined_or(const std::vector<std::string>& words, const std::string& otherwise) {
    return words.empty() ? otherwise : fmt::format("{}", fmt::join(words, ", "));
}

std::string range_of(const Signal& signal) {
    if (!signal.minimum || !signal.maximum) {
        return "";
    }
    return fmt::format("{} … {}{}{}", *signal.minimum, *signal.maximum, signal.unit.empty() ? "" : " ", signal.unit);
}

std::vector<std::vector<std::string>> requirement_rows(const Part& part, const std::string& kind) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& one : part.requirements) {
        if (one.kind == kind && one.retired.empty()) {
            rows.push_back({one.id, one.text, joined_or(origins(one))});
        }
    }
    return rows;
}

std::set<std::int64_t> bit_rates_of(const Part& part) {
    std::set<std::int64_t> rates(part.info.bit_rates.begin(), part.info.bit_rates.end());
    for (const auto& table : part.tables) {
        for (std::size_t at = 0; at < table.outputs.size(); ++at) {
            if (table.outputs[at].name == "bit_rate") {
                add_numbers(table, table.inputs.size() + at, rates);
            }
        }
    }
    rates.erase(0);  // the rate of a reserved index
    return rates;
}

std::string manual_words(const Register& content, const Part& part) {
    const Manual* manual = content.manual(part.info.manual);
    return manual == nullptr ? part.info.manual
                             : fmt::format("{}, {}, revision {} of {}", manual->title, manual->publisher,
                                           manual->revision, manual->date);
}

}  // namespace canproof::host
