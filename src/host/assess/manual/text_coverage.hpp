// SPDX-License-Identifier: Apache-2.0
// The coverage of a manual's text by its statements.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

/// Text of a normative section that no statement covers.
struct UncoveredLine {
    std::size_t line{0};  ///< counts from 1
    std::string section;
    std::string words;  ///< the first words that are not covered
};

/// Number of letters and digits in total and within passages with a mark.
struct CoveredCharacters {
    std::size_t all{0};
    std::size_t covered{0};
    double percent() const;
};

struct TextCoverage {
    std::size_t marks{0};
    std::vector<std::string> missing;      ///< `KEY:SECTION/N: MARK` of passages that the text does not contain
    std::vector<std::string> not_located;  ///< normative numbered sections whose heading was not found
    std::vector<UncoveredLine> uncovered;
    CoveredCharacters normative;  ///< text of the located normative sections, without headings and captions
    CoveredCharacters whole;
};

/// Finds the marks of the manual's statements in a text version of it. All text, tables and figures belong to the
/// numbered section whose heading stands above them.
TextCoverage cover_text(const Manual& manual, const std::string& text);

}  // namespace canproof::host
