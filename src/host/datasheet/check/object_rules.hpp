// SPDX-License-Identifier: Apache-2.0
// Rules for objects and their sub-objects in an EDS. object_rules.cpp contains the table of these rules.
#pragma once

#include <vector>

#include "host/datasheet/check/eds_findings.hpp"
#include "host/datasheet/check/eds_sheet.hpp"

namespace canproof::host {

/// Returns the rules for objects.
const std::vector<EdsRule>& object_rules();
/// Checks the sheet against these rules and adds each violation to `findings`.
void check_object(const EdsSheet& sheet, EdsFindings& findings);

}  // namespace canproof::host
