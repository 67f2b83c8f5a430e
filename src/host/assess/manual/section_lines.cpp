// SPDX-License-Identifier: Apache-2.0
#include "host/assess/manual/section_lines.hpp"

#include <algorithm>
#include <map>
#include <sstream>

#include "host/assess/manual/manual_text.hpp"
#include "host/register/mark.hpp"

namespace canproof::host {

namespace {

/// Returns the parts of a section number: {7, 10, 2} for "7.10.2". Returns an empty list for any other text.
std::vector<unsigned> number_of(const std::string& ref) {
    std::vector<unsigned> number;
    std::istringstream in{ref};
    for (std::string part; std::getline(in, part, '.');) {
        constexpr std::size_t most_digits = 4;
        if (part.empty() || part.size() > most_digits || part.find_first_not_of("0123456789") != std::string::npos) {
            return {};
        }
        number.push_back(static_cast<unsigned>(std::stoul(part)));
    }
    return number;
}

/// Returns the words of the text in lower case. A word consists of letters and digits.
std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> words;
    bool within = false;
    for (const char c : text) {
        const std::string kept = reduced(std::string(1, c));
        if (!kept.empty() && !within) {
            words.emplace_back();
        }
        within = !kept.empty();
        if (within) {
            words.back() += kept;
        }
    }
    return words;
}

/// Returns the section number at the start of a line: `7.10.2` for "7.10.2. Write Analog Output". Returns an empty text
/// when there is none.
std::string leading_number(const std::string& line) {
    std::string number = line.substr(0, line.find_first_not_of("0123456789."));
    while (!number.empty() && number.back() == '.') {
        number.pop_back();
    }
    return number;
}

/// Returns whether the line, from which the caller has removed the section's number, is the heading of the section. The
/// words of a line need not match the title if the number has three or more parts: only a heading begins with 7.10.2,
/// and the register may paraphrase its title.
bool is_heading(const std::string& line, const Section& section) {
    const std::vector<std::string> wanted = words_of(section.title);
    const std::vector<std::string> words = words_of(line);
    const auto is_there = [&](const std::string& word) {
        return std::find(words.begin(), words.end(), word) != words.end();
    };
    const bool ends_with_number =
        !words.empty() && line.back() != ')' && words.back().find_first_not_of("0123456789") == std::string::npos;
    if (wanted.empty() || (ends_with_number && words.back() != wanted.back())) {
        return false;
    }
    const bool is_enough = std::count(section.ref.begin(), section.ref.end(), '.') >= 2;
    return is_enough ||
           2 * std::count_if(wanted.begin(), wanted.end(), is_there) >= static_cast<std::ptrdiff_t>(wanted.size());
}

}  // namespace

std::vector<SectionLines> section_lines(const Manual& manual, const std::vector<std::string>& lines) {
    std::map<std::vector<unsigned>, const Section*> sections;
    for (const Section& section : manual.sections) {
        if (const auto number = number_of(section.ref); !number.empty()) {
            sections[number] = &section;
        }
    }
    std::map<std::string, std::vector<std::size_t>> numbered;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (const std::string number = leading_number(without_markup(lines[i])); !number.empty()) {
            numbered[number].push_back(i);
        }
    }
    std::vector<SectionLines> found;
    std::size_t next = lines.size();
    for (auto one = sections.rbegin(); one != sections.rend(); ++one) {
        const Section& section = *one->second;
        const auto candidates = numbered.find(section.ref);
        if (candidates == numbered.end()) {
            continue;
        }
        const auto& at = candidates->second;
        const auto line = std::find_if(at.rbegin(), at.rend(), [&](const std::size_t i) {
            return i < next && is_heading(without_markup(lines[i]).substr(section.ref.size()), section);
        });
        if (line != at.rend()) {
            found.push_back({&section, *line, next});
            next = *line;
        }
    }
    std::reverse(found.begin(), found.end());
    return found;
}

}  // namespace canproof::host
