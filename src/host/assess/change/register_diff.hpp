// What differs between two registers, item by item: the start of an impact analysis.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

struct ItemChange {
    enum class Kind { added, removed, changed } kind{Kind::changed};
    std::string id;
    std::string word;                  ///< requirement, object, table …, decision, statement
    std::vector<std::string> details;  ///< `sub 1 default: 5 -> 6`; none for what was added or removed
};

/// Everything that an item says, by facet: `text`, `sub 1 default`, `row 3` …
using Facets = std::map<std::string, std::string>;

struct DescribedItem {
    std::string word;
    Facets facets;
};
/// All items and decisions of a register by id, and the statements of its manuals by place and mark.
std::map<std::string, DescribedItem> describe(const Register& content);

/// In the order of their ids.
std::vector<ItemChange> compare(const Register& before, const Register& after);

}  // namespace canproof::host
