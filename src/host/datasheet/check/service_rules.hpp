// SPDX-License-Identifier: Apache-2.0
// Rules for objects of services; service_rules.cpp contains their table.
#pragma once

#include <vector>

#include "host/datasheet/check/eds_findings.hpp"
#include "host/datasheet/check/eds_sheet.hpp"

namespace canproof::host {

/// Returns the rules for services.
const std::vector<EdsRule>& service_rules();
/// Checks the sheet against these rules and adds each violation to `findings`.
void check_service(const EdsSheet& sheet, EdsFindings& findings);

}  // namespace canproof::host
