// SPDX-License-Identifier: Apache-2.0
// Rules for the three lists of objects in an EDS. list_rules.cpp contains the table of these rules.
#pragma once

#include <vector>

#include "host/datasheet/check/eds_findings.hpp"
#include "host/datasheet/check/eds_sheet.hpp"

namespace canproof::host {

/// Returns the rules for the lists of objects.
const std::vector<EdsRule>& list_rules();
/// Checks the sheet against these rules and adds each violation to `findings`.
void check_list(const EdsSheet& sheet, EdsFindings& findings);

}  // namespace canproof::host
