// SPDX-License-Identifier: Apache-2.0
// Checks an electronic data sheet against CiA 306 and CiA 301. Each finding names its rule, its line and its fix. XDD
// files are not checked.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/datasheet/check/eds_finding.hpp"

namespace canproof::host {

/// Returns every rule, in the order of the groups: text, lists, objects, entries, values, mapping, PDO, services,
/// sections.
std::vector<EdsRule> eds_rules();

/// Returns the findings of all rules, ascending by line, at most Faults::most. `name` is the name of the file without
/// its folder. If it is empty, checks that depend on it are left out.
/// A text is a device configuration file if its name ends in .dcf. It is also one if it contains [DeviceComissioning]
/// and the name does not end in .eds. Such a file may have additional keys.
/// Throws InputError for a text that is no EDS: XML, more than most_strange_lines invalid lines, more than a million
/// lines, or no section.
std::vector<EdsFinding> check_eds(std::string_view text, std::string_view name = {});

}  // namespace canproof::host
