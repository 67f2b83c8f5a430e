// SPDX-License-Identifier: Apache-2.0
// Rules for PDO communication parameters in an EDS. pdo_rules.cpp contains the table of these rules.
#pragma once

#include <vector>

#include "host/datasheet/check/eds_findings.hpp"
#include "host/datasheet/check/eds_sheet.hpp"

namespace canproof::host {

/// Returns the rules for PDO communication parameters.
const std::vector<EdsRule>& pdo_rules();
/// Checks the sheet against these rules and adds each violation to `findings`.
void check_pdo(const EdsSheet& sheet, EdsFindings& findings);

}  // namespace canproof::host
