// SPDX-License-Identifier: Apache-2.0
// Assigns the lines of a manual's text to its sections.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

/// Lines [begin, end) from the heading of a section to the next heading; lines count from 0.
struct SectionLines {
    const Section* section{nullptr};
    std::size_t begin{0};
    std::size_t end{0};
};

/// Returns the numbered sections whose headings are in the text, in the order of the text. A heading begins with the
/// section's number, has no page number at its end, and is before the heading of the next section. After a number of
/// one or two parts, it must contain at least half of the words of the title. If several lines qualify, the last one is
/// the heading.
std::vector<SectionLines> section_lines(const Manual& manual, const std::vector<std::string>& lines);

}  // namespace canproof::host
