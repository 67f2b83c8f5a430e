// SPDX-License-Identifier: Apache-2.0
// The differences between two requirements registers, item by item; an impact analysis starts from them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

struct ItemChange {
    enum class Kind { added, removed, changed } kind{Kind::changed};
    std::string id;
    std::string word;                  ///< kind of the item: requirement, object, table, decision, statement …
    std::vector<std::string> details;  ///< for example `sub 1 default: 5 -> 6`; empty for an added or removed item
};

/// The values of an item's facets (parts) by their names: `text`, `sub 1 default`, `row 3` …
using Facets = std::map<std::string, std::string>;

struct DescribedItem {
    std::string word;
    Facets facets;
};
/// Returns all items and decisions of a register by id, and the statements of its manuals by section and passage mark
/// (a hash of the passage).
std::map<std::string, DescribedItem> describe(const Register& content);

/// Returns the items that differ between two registers, in the order of their ids.
std::vector<ItemChange> compare(const Register& before, const Register& after);

}  // namespace canproof::host
