// How much of a manual's text its statements cover.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

/// Text of a normative section that no statement covers.
struct UncoveredLine {
    std::size_t line{0};  ///< from 1
    std::string section;
    std::string words;  ///< the first ones that are not covered
};

/// Letters and digits, all of them and those of passages with a mark.
struct CoveredCharacters {
    std::size_t all{0};
    std::size_t covered{0};
    double percent() const;
};

struct TextCoverage {
    std::size_t marks{0};
    std::vector<std::string> missing;      ///< `KEY:SECTION/N: MARK` of passages that are not in the text
    std::vector<std::string> not_located;  ///< normative numbered sections whose heading is not found
    std::vector<UncoveredLine> uncovered;
    CoveredCharacters normative;  ///< of the located normative sections, without headings and captions
    CoveredCharacters whole;
};

/// Finds the marks of the manual's statements in a text version of it. Text belongs to the numbered section whose
/// heading stands above it: tables, figures and objects too.
TextCoverage cover_text(const Manual& manual, const std::string& text);

}  // namespace canproof::host
