// Checks an electronic data sheet (CiA 306) against CiA 306 and CiA 301: each finding names its rule, its line and how
// to fix it. XDD files are not checked.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/datasheet/check/eds_finding.hpp"

namespace canproof::host {

/// Every rule, in the order of the groups: text, lists, objects, entries, values, mapping, PDO, services, sections.
std::vector<EdsRule> eds_rules();

/// Finds what the rules find, ascending by line. `name` is the file's name without folder; empty: what depends on it is
/// not checked. A name that ends in .dcf, or [DeviceComissioning] unless the name ends in .eds, makes the text a device
/// configuration file, which has keys of its own. At most Faults::most findings are returned. Throws InputError for a
/// text that is no EDS at all: XML, more than most_strange_lines lines of another form, more than a million lines, or
/// no section.
std::vector<EdsFinding> check_eds(std::string_view text, std::string_view name = {});

}  // namespace canproof::host
