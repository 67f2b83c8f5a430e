// SPDX-License-Identifier: Apache-2.0
#include "host/register/check_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "host/register/literals.hpp"

namespace canproof::host {

namespace {

/// Greatest number of inputs of a table. The check calls itself once for each input, so this number limits its depth.
constexpr std::size_t most_inputs = 32;
/// Greatest number of steps of the check. Each table of canproof's register needs less than a tenth of these steps.
constexpr std::size_t most_steps = 4000000;

/// Checks one decision table. Divides the values of each input into pieces, so that a row matches a piece completely or
/// not at all. Each combination of pieces must match exactly one row.
class TableCheck {
  public:
    TableCheck(const Register& content, const Part& part, Table& table, Faults& faults)
        : content_{content}, part_{part}, table_{table}, faults_{faults} {}

    void run() {
        const std::size_t before = faults_.size();
        std::set<std::string> names;
        for (auto* columns : {&table_.inputs, &table_.outputs}) {
            for (Column& column : *columns) {
                resolve(column);
                check_column(column, columns == &table_.inputs);
                if (!names.insert(column.name).second) {
                    fault(column.place, fmt::format("{} has two columns {}", table_.id, column.name),
                          "give each column its own name");
                }
            }
        }
        if (table_.inputs.size() > most_inputs) {
            fault(table_.place, fmt::format("{} has {} inputs", table_.id, table_.inputs.size()),
                  fmt::format("divide the table into tables of at most {} inputs", most_inputs));
        }
        check_cells();
        if (faults_.size() == before && table_.complete) {
            std::vector<std::size_t> rows(table_.rows.size());
            for (std::size_t i = 0; i < rows.size(); ++i) {
                rows[i] = i;
            }
            for (std::size_t i = 0; i < table_.inputs.size(); ++i) {
                pieces_.push_back(pieces(i));
            }
            std::vector<std::string> at;
            cover(0, rows, at);
            if (steps_ > most_steps) {
                fault(table_.place, fmt::format("{} has too many rows and combinations to be checked", table_.id),
                      "divide the table into several tables");
            }
        }
    }

  private:
    void fault(const Place& place, const std::string& what, const std::string& fix) {
        faults_.push_back({place, what, fix});
    }

    void resolve(Column& column) {
        if (column.enumeration.empty()) {
            return;
        }
        const Enumeration* found = content_.enumeration(part_, column.enumeration);
        if (found == nullptr) {
            fault(column.place,
                  fmt::format("{} column {} names enumeration {}, which does not exist", table_.id, column.name,
                              column.enumeration),
                  "name an [[enumeration]] of this device or of spec/canopen");
            return;
        }
        column.words.clear();
        for (const auto& [word, number] : found->values) {
            column.words.push_back(word);
        }
    }

    void check_column(const Column& column, bool input) {
        if (!column.name.empty() && !is_cpp_name(column.name)) {
            fault(column.place, fmt::format("{} column {} is no C++ name", table_.id, column.name),
                  "use letters, digits and underscores, begin with a letter, and use no C++ keyword");
        }
        if (!column.type.empty() && (!is_known_type(column.type) || type_size(column.type) == 0)) {
            fault(column.place,
                  fmt::format("{} column {} has the unknown type {}", table_.id, column.name, column.type),
                  "use BOOLEAN, an integer type, REAL32 or REAL64");
        }
        if (!column.type.empty() && (input || !column.enumeration.empty())) {
            fault(column.place, fmt::format("{} column {} must not have a type", table_.id, column.name),
                  input ? "remove `type`: the cells of an input determine its type"
                        : "keep `type` or `enumeration`, not both");
        }
        if (input && column.kind == Column::Kind::reals) {
            fault(column.place, fmt::format("{} input {} is a REAL32", table_.id, column.name),
                  "use whole numbers, booleans or words: their combinations can be counted");
        }
        std::set<std::string> words;
        for (const auto& word : column.words) {
            if (column.kind == Column::Kind::words &&
                (snake_case(word).empty() || !words.insert(snake_case(word)).second)) {
                fault(column.place,
                      fmt::format("{} column {} has no C++ name of its own for the word \"{}\"", table_.id, column.name,
                                  word),
                      "use words that differ in their letters and digits");
            }
        }
    }

    void check_cells() {
        for (const auto* columns : {&table_.inputs, &table_.outputs}) {
            for (const Column& column : *columns) {
                words_.emplace_back(column.words.begin(), column.words.end());
            }
        }
        for (const auto& row : table_.rows) {
            for (std::size_t i = 0; i < row.cells.size(); ++i) {
                const bool input = i < table_.inputs.size();
                const Column& column = input ? table_.inputs[i] : table_.outputs[i - table_.inputs.size()];
                if (!input &&
                    (row.cells[i].parts.size() != 1 || row.cells[i].parts[0].first != row.cells[i].parts[0].last)) {
                    fault(row.place, fmt::format("{} output {} is not one value", table_.id, column.name),
                          "write a single literal");
                    continue;
                }
                for (const auto& part : row.cells[i].parts) {
                    check_part(row, i, part);
                }
            }
        }
    }

    void check_part(const Table::Row& row, std::size_t i, const Cell::Part& part) {
        const bool input = i < table_.inputs.size();
        const Column& column = input ? table_.inputs[i] : table_.outputs[i - table_.inputs.size()];
        bool fits = false;
        if (input && column.kind == Column::Kind::reals) {
            return;  // check_column() reports an input column of reals as a fault
        }
        if (!input && is_known_type(column.type)) {
            fits = fits_type(part.first, column.type);
        } else if (column.kind == Column::Kind::words) {
            const auto* word = std::get_if<std::string>(&part.first);
            fits = word != nullptr && words_[i].count(*word) != 0;
        } else if (column.kind == Column::Kind::booleans) {
            fits = std::holds_alternative<bool>(part.first);
        } else if (column.kind == Column::Kind::reals) {
            fits = (std::holds_alternative<double>(part.first) || std::holds_alternative<std::int64_t>(part.first));
        } else {
            const auto* first = std::get_if<std::int64_t>(&part.first);
            const auto* last = std::get_if<std::int64_t>(&part.last);
            fits = first != nullptr && last != nullptr && *first <= *last && *first >= *column.minimum &&
                   *last <= *column.maximum;
        }
        if (!fits) {
            fault(row.place,
                  fmt::format("{} value {} is outside the domain of {}", table_.id, to_text(part.first), column.name),
                  "correct the cell or the column's domain");
        }
    }

    /// Checks each combination of pieces (parts of a column's values) from input column `i` on. `at` describes the
    /// pieces of the columns before it, and `rows` are the rows that match these pieces. For each piece of column `i`,
    /// checks the next column with those of `rows` that also match this piece.
    void cover(std::size_t i, const std::vector<std::size_t>& rows, std::vector<std::string>& at) {
        if (i == table_.inputs.size()) {
            judge(rows, at);
            return;
        }
        for (const auto& [words, first] : pieces_[i]) {
            steps_ += rows.size() + 1;
            if (told_ >= 5 || steps_ > most_steps) {
                return;  // reports at most five gaps or overlaps, because a table with one of them usually has many
            }
            std::vector<std::size_t> left;
            for (const std::size_t row : rows) {
                if (matches(table_.rows[row].cells[i], first)) {
                    left.push_back(row);
                }
            }
            at.push_back(fmt::format("{} = {}", table_.inputs[i].name, words));
            cover(i + 1, left, at);
            at.pop_back();
        }
    }

    void judge(const std::vector<std::size_t>& rows, const std::vector<std::string>& at) {
        if (rows.size() == 1) {
            return;
        }
        ++told_;
        const std::string combination = fmt::format("{}", fmt::join(at, ", "));
        if (rows.empty()) {
            fault(table_.place, fmt::format("{} has a gap: no row for {}", table_.id, combination),
                  "add a row for this combination");
        } else {
            fault(table_.rows[rows[1]].place,
                  fmt::format("{} has an overlap: {} is covered by line {} too", table_.id, combination,
                              table_.rows[rows[0]].place.line),
                  "change the rows so that only one covers this combination");
        }
    }

    static bool matches(const Cell& cell, const Value& value) {
        if (cell.any()) {
            return true;
        }
        return std::any_of(cell.parts.begin(), cell.parts.end(), [&](const Cell::Part& part) {
            if (const auto* v = std::get_if<std::int64_t>(&value)) {
                return *v >= std::get<std::int64_t>(part.first) && *v <= std::get<std::int64_t>(part.last);
            }
            return part.first == value;
        });
    }

    std::vector<std::pair<std::string, Value>> pieces(std::size_t i) const {
        const Column& column = table_.inputs[i];
        std::vector<std::pair<std::string, Value>> all;
        if (column.kind == Column::Kind::words) {
            for (const auto& word : column.words) {
                all.emplace_back(word, word);
            }
        } else if (column.kind == Column::Kind::booleans) {
            all.emplace_back("false", false);
            all.emplace_back("true", true);
        } else {
            std::set<std::int64_t> starts{*column.minimum};
            for (const auto& row : table_.rows) {
                for (const auto& part : row.cells[i].parts) {
                    starts.insert(std::get<std::int64_t>(part.first));
                    if (const auto last = std::get<std::int64_t>(part.last); last < *column.maximum) {
                        starts.insert(last + 1);
                    }
                }
            }
            for (const std::int64_t start : starts) {
                if (start <= *column.maximum) {
                    all.emplace_back(std::to_string(start), start);
                }
            }
        }
        return all;
    }

    const Register& content_;
    const Part& part_;
    Table& table_;
    Faults& faults_;
    std::vector<std::vector<std::pair<std::string, Value>>> pieces_;  ///< pieces of each input column
    std::vector<std::set<std::string>> words_;                        ///< words of each column
    std::size_t steps_{0};                                            ///< number of rows that were compared so far
    int told_{0};
};

}  // namespace

void check_tables(const Register& content, Part& part, Faults& faults) {
    for (Table& table : part.tables) {
        TableCheck{content, part, table, faults}.run();
    }
}

}  // namespace canproof::host
