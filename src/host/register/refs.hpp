// SPDX-License-Identifier: Apache-2.0
// The names of places in a manual: "1.3", "Table 7", "Figure 2", "2340h".
#pragma once

#include <set>
#include <string>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns the single places in a source: "1.3" and "Table 7" for "1.3 Table 7".
std::vector<std::string> split_refs(const std::string& text);

/// Returns the names of all places of a manual: its sections, tables and figures, and the objects that they describe.
std::set<std::string> refs_of(const Manual& manual);

/// Returns whether `ref` is the section `above` or one below it: 1.3.2 is below 1.3. A table, figure or object has
/// nothing below it.
bool is_within(const std::string& ref, const std::string& above);

}  // namespace canproof::host
