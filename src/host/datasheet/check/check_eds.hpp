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

/// Returns the findings of all rules, ascending by line, at most Faults::most. `name` is the name of the file without
/// its folder. If `name` is empty, leaves out the checks that depend on the name. A text is a device configuration file
/// if its name ends in .dcf. A text with [DeviceComissioning] is also a device configuration file if its name does not
/// end in .eds. Such a file may have additional keys. Throws InputError for a text that is no EDS: XML, more than
/// most_strange_lines invalid lines, more than a million lines, or no section.
std::vector<EdsFinding> check_eds(std::string_view text, std::string_view name = {});

}  // namespace canproof::host
