// Rules of one kind: see the table in small_section_rules.cpp.
#pragma once

#include <vector>

#include "host/datasheet/check/eds_findings.hpp"
#include "host/datasheet/check/eds_sheet.hpp"

namespace canproof::host {

/// The rules of this group.
const std::vector<EdsRule>& small_section_rules();
/// Adds what they find in the sheet.
void check_small_section(const EdsSheet& sheet, EdsFindings& findings);

}  // namespace canproof::host
