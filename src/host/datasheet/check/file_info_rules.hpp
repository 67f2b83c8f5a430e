// SPDX-License-Identifier: Apache-2.0
// Rules for the section [FileInfo] of an EDS. file_info_rules.cpp contains the table of these rules.
#pragma once

#include <vector>

#include "host/datasheet/check/eds_findings.hpp"
#include "host/datasheet/check/eds_sheet.hpp"

namespace canproof::host {

/// Returns the rules for [FileInfo].
const std::vector<EdsRule>& file_info_rules();
/// Checks the sheet against these rules and adds each violation to `findings`.
void check_file_info(const EdsSheet& sheet, EdsFindings& findings);

}  // namespace canproof::host
