// SPDX-License-Identifier: Apache-2.0
// Checks an electronic data sheet against CiA 306 and CiA 301. Each finding names its rule, its line and its fix. XDD
// files are not checked.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/datasheet/check/eds_finding.hpp"

namespace canproof::host {

/// Returns every rule, in the order of the groups: text, FileInfo, DeviceInfo, small sections, lists, objects, entries,
/// values, mapping, PDO, services.
std::vector<EdsRule> eds_rules();

/// Checks the text by all rules and returns the findings, ascending by line and at most Faults::most (10,000). `name`
/// is the name of the file without its folder; if it is empty, no check depends on the name. A text is a device
/// configuration file if `name` ends in .dcf, or if it has [DeviceComissioning] and `name` does not end in .eds. A
/// device configuration file may have additional keys. Throws InputError for a text that is no EDS: XML, no section,
/// more than most_strange_lines invalid lines, or more than a million lines.
std::vector<EdsFinding> check_eds(std::string_view text, std::string_view name = {});

}  // namespace canproof::host
