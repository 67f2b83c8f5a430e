// Rules of one kind: see the table in entry_rules.cpp.
#pragma once

#include <vector>

#include "host/datasheet/check/eds_findings.hpp"
#include "host/datasheet/check/eds_sheet.hpp"

namespace canproof::host {

/// The rules of this group.
const std::vector<EdsRule>& entry_rules();
/// Adds what they find in the sheet.
void check_entry(const EdsSheet& sheet, EdsFindings& findings);

}  // namespace canproof::host
