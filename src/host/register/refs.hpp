// How the places of a manual are named: "1.3", "Table 7", "Figure 2", "2340h".
#pragma once

#include <set>
#include <string>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

/// "1.3 Table 7" → "1.3", "Table 7".
std::vector<std::string> split_refs(const std::string& text);

/// All places of a manual: its sections, tables and figures, and the objects that they describe.
std::set<std::string> refs_of(const Manual& manual);

/// Whether `ref` is the section `above` or one below it: 1.3.2 is in 1.3. Tables, figures and objects are in
/// themselves only.
bool is_within(const std::string& ref, const std::string& above);

}  // namespace canproof::host
