// A normative statement of a manual, in our words.
#pragma once

#include <string>
#include <vector>

#include "host/register/fault.hpp"
#include "host/register/mark.hpp"

namespace canproof::host {

/// What one sentence of a manual asks for, and the items that cover it. With neither items nor a reason it is a gap.
struct Statement {
    std::string section;               ///< a section, table, figure or object of its manual
    unsigned number{0};                ///< among the statements of that section, from 1
    std::string text;                  ///< our words
    std::vector<Mark> marks;           ///< of the passages that say it
    std::vector<std::string> covered;  ///< ids of items and decisions
    std::string reason;                ///< why no item covers it
    Place place;
    Place section_place;
    Place mark_place;
    Place covered_place;

    bool is_open() const { return covered.empty() && reason.empty(); }
    /// `AX130751:1.3/2` in the manual with that key.
    std::string id(const std::string& key) const { return key + ":" + section + "/" + std::to_string(number); }
};

}  // namespace canproof::host
