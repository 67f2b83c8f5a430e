// The lines of a manual's text that belong to each section.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

/// Lines [begin, end) from the heading of a section to the next heading; they count from 0.
struct SectionLines {
    const Section* section{nullptr};
    std::size_t begin{0};
    std::size_t end{0};
};

/// The numbered sections whose headings are in the text, in its order. A heading begins with the section's number, has
/// no page number behind it, and stands before the heading of the section that follows. After a number of one or two
/// parts it has at least half of the words of the title. Of several such lines the last counts.
std::vector<SectionLines> section_lines(const Manual& manual, const std::vector<std::string>& lines);

}  // namespace canproof::host
