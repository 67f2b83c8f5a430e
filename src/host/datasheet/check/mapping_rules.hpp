// SPDX-License-Identifier: Apache-2.0
// Rules for PDO mappings in an EDS. mapping_rules.cpp contains the table of these rules.
#pragma once

#include <vector>

#include "host/datasheet/check/eds_findings.hpp"
#include "host/datasheet/check/eds_sheet.hpp"

namespace canproof::host {

/// Returns the rules for PDO mappings.
const std::vector<EdsRule>& mapping_rules();
/// Checks the sheet against these rules and adds each violation to `findings`.
void check_mapping(const EdsSheet& sheet, EdsFindings& findings);

}  // namespace canproof::host
