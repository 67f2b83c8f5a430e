// SPDX-License-Identifier: Apache-2.0
// A normative statement of a manual in the project's own words.
#pragma once

#include <string>
#include <vector>

#include "host/register/fault.hpp"
#include "host/register/mark.hpp"

namespace canproof::host {

/// The demand of one sentence of a manual, and the items that cover it. A statement with neither items nor a reason is
/// a gap.
struct Statement {
    std::string section;      ///< the section, table, figure or object of the manual to which the statement belongs
    unsigned number{0};       ///< number among the statements of that section, from 1
    std::string text;         ///< the statement in the project's own words
    std::vector<Mark> marks;  ///< marks (hashes) of the manual's passages that contain the statement
    std::vector<std::string> covered;  ///< ids of the items and decisions that cover the statement
    std::string reason;                ///< reason why no item has to cover the statement
    Place place;
    Place section_place;
    Place mark_place;
    Place covered_place;

    bool is_open() const { return covered.empty() && reason.empty(); }
    /// Returns the id of the statement, such as `AX130751:1.3/2`. `key` is the key of the manual.
    std::string id(const std::string& key) const { return key + ":" + section + "/" + std::to_string(number); }
};

}  // namespace canproof::host
