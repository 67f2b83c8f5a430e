// SPDX-License-Identifier: Apache-2.0
#include "host/assess/manual/text_coverage.hpp"

#include <algorithm>
#include <set>

#include "host/assess/manual/find_marks.hpp"
#include "host/assess/manual/manual_text.hpp"
#include "host/assess/manual/section_lines.hpp"

namespace canproof::host {

namespace {

/// Returns, for each letter and digit of the text, whether it belongs to a passage of a statement. Sets the number of
/// passage marks, and the marks whose passages are missing, in `coverage`.
std::vector<bool> covered_characters(const Manual& manual, const ManualText& text, TextCoverage& coverage) {
    std::set<Mark> marks;
    for (const Statement& statement : manual.statements) {
        marks.insert(statement.marks.begin(), statement.marks.end());
    }
    const auto places = find_marks(text, marks);
    coverage.marks = marks.size();
    for (const Statement& statement : manual.statements) {
        for (const Mark& mark : statement.marks) {
            if (places.count(mark) == 0) {
                coverage.missing.push_back(statement.id(manual.key) + ": " + mark.text());
            }
        }
    }
    std::vector<bool> covered(text.letters().size(), false);
    for (const auto& [mark, begins] : places) {
        for (const std::size_t begin : begins) {
            std::fill_n(covered.begin() + static_cast<std::ptrdiff_t>(begin), mark.length, true);
        }
    }
    return covered;
}

/// Returns whether the line is a Markdown heading or the caption of a table or figure.
bool is_title(const std::string& line) {
    const std::string words = without_markup(line);
    return line.rfind('#', 0) == 0 || words.rfind("Table ", 0) == 0 || words.rfind("Figure ", 0) == 0;
}

/// Returns the words of a line, beginning with the first letter or digit that no statement covers. Cuts them at the
/// last space within the first 70 characters.
std::string words_from(const ManualText& text, const std::size_t line, const std::vector<bool>& covered) {
    const auto begin = covered.begin() + static_cast<std::ptrdiff_t>(text.begin_of(line));
    const auto end = covered.begin() + static_cast<std::ptrdiff_t>(text.end_of(line));
    auto skipped = std::find(begin, end, false) - begin;
    const std::string& whole = text.lines()[line];
    std::size_t at = 0;
    const auto counts = [](const char c) { return !reduced(std::string(1, c)).empty(); };
    while (at < whole.size() && (skipped > 0 || !counts(whole[at]))) {
        skipped -= counts(whole[at]) ? 1 : 0;
        ++at;
    }
    constexpr std::size_t longest = 70;
    const std::string rest = whole.substr(at);
    return rest.size() <= longest ? rest : rest.substr(0, rest.rfind(' ', longest)) + " …";
}

}  // namespace

double CoveredCharacters::percent() const {
    return all == 0 ? 0.0 : 100.0 * static_cast<double>(covered) / static_cast<double>(all);
}

TextCoverage cover_text(const Manual& manual, const std::string& text_of_manual) {
    const ManualText text{text_of_manual};
    TextCoverage coverage;
    const std::vector<bool> covered = covered_characters(manual, text, coverage);
    const auto count_covered = [&](const std::size_t begin, const std::size_t end) {
        return static_cast<std::size_t>(std::count(covered.begin() + static_cast<std::ptrdiff_t>(begin),
                                                   covered.begin() + static_cast<std::ptrdiff_t>(end), true));
    };
    coverage.whole = {covered.size(), count_covered(0, covered.size())};
    std::set<const Section*> located;
    for (const SectionLines& one : section_lines(manual, text.lines())) {
        located.insert(one.section);
        for (std::size_t line = one.begin + 1; one.section->normative && line < one.end; ++line) {
            const std::size_t begin = text.begin_of(line);
            const std::size_t end = text.end_of(line);
            if (begin == end || is_title(text.lines()[line])) {
                continue;
            }
            const std::size_t here = count_covered(begin, end);
            coverage.normative.all += end - begin;
            coverage.normative.covered += here;
            if (here != end - begin) {
                coverage.uncovered.push_back({line + 1, one.section->ref, words_from(text, line, covered)});
            }
        }
    }
    for (const Section& section : manual.sections) {
        const bool is_numbered = section.ref.find_first_not_of("0123456789.") == std::string::npos;
        if (is_numbered && section.normative && located.count(&section) == 0) {
            coverage.not_located.push_back(section.ref);
        }
    }
    return coverage;
}

}  // namespace canproof::host
