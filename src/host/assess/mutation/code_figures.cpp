// SPDX-License-Identifier: Apache-2.0
#include "host/assess/mutation/code_figures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <iterator>
#include <sstream>

#include "host/assess/source/cpp_text.hpp"
#include "host/base/input_error.hpp"
#include "host/base/read_file.hpp"
#include "host/base/sha256.hpp"

namespace canproof::host {

namespace {

const char* const heading = "file,code,mutants,conformance,units,properties,otherwise,with a reason,open";
constexpr std::array<const char*, 4> harnesses{"conformance", "units", "properties", "otherwise"};
constexpr std::size_t field_count = 9;
constexpr std::size_t mark_digits = 8;

/// Returns the hash of a source without its comments, layout and implements<> assertions, which have no mutants.
/// Returns an empty text when the source does not exist.
std::string mark_of(const std::filesystem::path& file) {
    static const std::string link = "static_assert(implements<";
    if (!std::filesystem::is_regular_file(file)) {
        return "";
    }
    std::string code = without_layout(read_file(file));
    for (auto at = code.find(link); at != std::string::npos; at = code.find(link, at)) {
        code.erase(at, code.find(';', at) + 1U - at);
    }
    return sha256(code).substr(0, mark_digits);
}

std::size_t noticed_by(const OperatorCount& count, const std::string& harness) {
    const auto found = count.noticed.find(harness);
    return found == count.noticed.end() ? 0U : found->second;
}

std::size_t noticed(const OperatorCount& count) {
    return count.mutants - count.justified - count.open;
}

/// Reads one line of reports/code_figures.csv. Returns whether the line has the right form.
bool read_line(const std::string& line, CodeFigures& figures) {
    std::istringstream in{line};
    std::vector<std::string> fields;
    for (std::string field; std::getline(in, field, ',');) {
        fields.push_back(field);
    }
    if (fields.size() != field_count || fields[0].empty()) {
        return false;
    }
    std::vector<std::size_t> numbers;
    for (std::size_t at = 2; at < field_count; ++at) {
        if (fields[at].empty() || fields[at].size() > 9 ||
            fields[at].find_first_not_of("0123456789") != std::string::npos) {
            return false;
        }
        numbers.push_back(std::stoul(fields[at]));
    }
    FileFigures& one = figures[fields[0]];
    one.code = fields[1];
    one.count.mutants = numbers[0];
    for (std::size_t at = 0; at < harnesses.size(); ++at) {
        one.count.noticed[harnesses[at]] = numbers[1 + at];
    }
    one.count.justified = numbers[5];
    one.count.open = numbers[6];
    return true;
}

void add(OperatorCount& to, const OperatorCount& more) {
    to.mutants += more.mutants;
    to.justified += more.justified;
    to.open += more.open;
    for (const auto& [harness, count] : more.noticed) {
        to.noticed[harness] += count;
    }
}

std::string row(const std::string& name, const OperatorCount& count) {
    const double share = 100.0 * static_cast<double>(noticed(count)) / static_cast<double>(count.mutants);
    std::string text = fmt::format("| {} | {} | {} ({:.1f} %)", name, count.mutants, noticed(count), share);
    for (const char* harness : harnesses) {
        text += fmt::format(" | {}", noticed_by(count, harness));
    }
    return text + fmt::format(" | {} | {} |\n", count.justified, count.open);
}

}  // namespace

CodeFigures read_code_figures(const std::filesystem::path& file) {
    CodeFigures figures;
    if (!std::filesystem::exists(file)) {
        return figures;
    }
    std::istringstream in{read_file(file)};
    std::size_t number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        if ((number != 1 || line != heading) && !read_line(line, figures)) {
            throw InputError{fmt::format(
                "{}:{}: the line does not have the form `{}`; remove this line, then run `canproof mutate --code`",
                file.string(), number, heading)};
        }
    }
    return figures;
}

std::string write_code_figures(const CodeFigures& figures) {
    std::string text = std::string{heading} + "\n";
    for (const auto& [file, one] : figures) {
        std::vector<std::string> fields{file, one.code, std::to_string(one.count.mutants)};
        for (const char* harness : harnesses) {
            fields.push_back(std::to_string(noticed_by(one.count, harness)));
        }
        fields.push_back(std::to_string(one.count.justified));
        fields.push_back(std::to_string(one.count.open));
        text += fmt::format("{}\n", fmt::join(fields, ","));
    }
    return text;
}

void note_figures(CodeFigures& figures, const std::vector<MutationOutcome>& outcomes,
                  const std::filesystem::path& root) {
    for (auto one = figures.begin(); one != figures.end();) {
        one = std::filesystem::is_regular_file(root / one->first) ? std::next(one) : figures.erase(one);
    }
    for (const MutationOutcome& outcome : outcomes) {
        figures.erase(outcome.cell.item);
    }
    for (const MutationOutcome& outcome : outcomes) {
        FileFigures& one = figures[outcome.cell.item];
        if (one.count.mutants == 0) {
            one.code = mark_of(root / outcome.cell.item);
        }
        ++one.count.mutants;
        one.count.open += outcome.open() ? 1U : 0U;
        if (!outcome.killed_by.empty()) {
            ++one.count.noticed[harness_of(outcome.killer_file)];
        } else if (outcome.record != nullptr) {
            ++one.count.justified;
        }
    }
}

LayerTable layer_table(const CodeFigures& figures, const std::vector<AlteredCell>& mutants,
                       const std::filesystem::path& root) {
    std::map<std::string, std::size_t> present;
    for (const AlteredCell& mutant : mutants) {
        ++present[mutant.item];
    }
    LayerTable table;
    std::map<std::string, OperatorCount> layers;
    OperatorCount all;
    for (const auto& [file, count] : present) {
        const auto found = figures.find(file);
        if (found == figures.end() || found->second.count.mutants != count ||
            found->second.code != mark_of(root / file)) {
            table.unjudged.push_back(fmt::format("{} ({} mutants)", file, count));
            continue;
        }
        add(layers[layer_of(file)], found->second.count);
        add(all, found->second.count);
    }
    table.open = all.open;
    table.text =
        "| layer | mutants | noticed | by conformance tests | by unit tests | by properties | by a time-out, a signal "
        "or at start "
        "| with a reason | open |\n|---|---|---|---|---|---|---|---|---|\n";
    for (const auto& [layer, count] : layers) {
        table.text += row(layer, count);
    }
    if (all.mutants != 0) {
        table.text += row("all", all);
    }
    return table;
}

}  // namespace canproof::host
