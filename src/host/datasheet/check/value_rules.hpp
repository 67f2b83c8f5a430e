// SPDX-License-Identifier: Apache-2.0
// Rules for defaults and limits in an EDS. value_rules.cpp contains the table of these rules.
#pragma once

#include <vector>

#include "host/datasheet/check/eds_findings.hpp"
#include "host/datasheet/check/eds_sheet.hpp"

namespace canproof::host {

/// Returns the rules for defaults and limits.
const std::vector<EdsRule>& value_rules();
/// Checks the sheet against these rules and adds each violation to `findings`.
void check_value(const EdsSheet& sheet, EdsFindings& findings);

}  // namespace canproof::host
