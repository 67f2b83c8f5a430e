// SPDX-License-Identifier: Apache-2.0
// A normative statement of a manual in our words.
#pragma once

#include <string>
#include <vector>

#include "host/register/fault.hpp"
#include "host/register/mark.hpp"

namespace canproof::host {

/// The demand of one sentence of a manual, and the items that cover it. A statement with neither items nor a reason is
/// a gap.
struct Statement {
    std::string section;               ///< a section, table, figure or object of its manual
    unsigned number{0};                ///< number among the statements of that section, counted from 1
    std::string text;                  ///< our words
    std::vector<Mark> marks;           ///< marks of the passages that contain it
    std::vector<std::string> covered;  ///< ids of items and decisions
    std::string reason;                ///< reason why no item covers it
    Place place;
    Place section_place;
    Place mark_place;
    Place covered_place;

    bool is_open() const { return covered.empty() && reason.empty(); }
    /// Returns the id `AX130751:1.3/2`; `key` is the key of the manual.
    std::string id(const std::string& key) const { return key + ":" + section + "/" + std::to_string(number); }
};

}  // namespace canproof::host
