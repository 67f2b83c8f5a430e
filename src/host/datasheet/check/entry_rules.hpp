// SPDX-License-Identifier: Apache-2.0
// Rules for the entries of objects in an EDS. entry_rules.cpp contains the table of these rules.
#pragma once

#include <vector>

#include "host/datasheet/check/eds_findings.hpp"
#include "host/datasheet/check/eds_sheet.hpp"

namespace canproof::host {

/// Returns the rules for entries of objects.
const std::vector<EdsRule>& entry_rules();
/// Checks the sheet against these rules and adds each violation to `findings`.
void check_entry(const EdsSheet& sheet, EdsFindings& findings);

}  // namespace canproof::host
