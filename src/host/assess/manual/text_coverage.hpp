// SPDX-License-Identifier: Apache-2.0
// The coverage of a manual's text by its statements.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

/// A line of a normative section whose text the statements do not cover completely.
struct UncoveredLine {
    std::size_t line{0};  ///< line number from 1
    std::string section;
    std::string words;  ///< the first words of the line that no statement covers
};

/// Numbers of letters and digits: in total, and inside the passages of statements.
struct CoveredCharacters {
    std::size_t all{0};
    std::size_t covered{0};
    double percent() const;
};

struct TextCoverage {
    std::size_t marks{0};
    /// Passages that the text does not contain, as `KEY:SECTION/N: MARK`: the id of the statement, and the hash of its
    /// passage.
    std::vector<std::string> missing;
    std::vector<std::string> not_located;  ///< normative numbered sections whose heading the text does not contain
    std::vector<UncoveredLine> uncovered;
    CoveredCharacters normative;  ///< counts for the normative sections whose heading was found, without headings and
                                  ///< captions
    CoveredCharacters whole;
};

/// Compares the passages of the manual's statements, which their marks (hashes) identify, with a text version of the
/// manual. All text, tables and figures belong to the numbered section with the nearest heading above them.
TextCoverage cover_text(const Manual& manual, const std::string& text);

}  // namespace canproof::host
