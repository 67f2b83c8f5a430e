// SPDX-License-Identifier: Apache-2.0
// Rules for the objects 1000h to 12FFh in an EDS. service_rules.cpp contains the table of these rules.
#pragma once

#include <vector>

#include "host/datasheet/check/eds_findings.hpp"
#include "host/datasheet/check/eds_sheet.hpp"

namespace canproof::host {

/// Returns the rules for the objects of communication services (SYNC, EMCY, SDO …).
const std::vector<EdsRule>& service_rules();
/// Checks the sheet against these rules and adds each violation to `findings`.
void check_service(const EdsSheet& sheet, EdsFindings& findings);

}  // namespace canproof::host
