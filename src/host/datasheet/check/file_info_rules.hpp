// SPDX-License-Identifier: Apache-2.0
// Rules for [FileInfo]; file_info_rules.cpp contains their table.
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
