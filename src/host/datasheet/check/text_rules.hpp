// SPDX-License-Identifier: Apache-2.0
// Rules for the text of a sheet; text_rules.cpp contains their table.
#pragma once

#include <vector>

#include "host/datasheet/check/eds_findings.hpp"
#include "host/datasheet/check/eds_sheet.hpp"

namespace canproof::host {

/// Returns the rules for the text of the file.
const std::vector<EdsRule>& text_rules();
/// Checks the sheet against these rules and adds each violation to `findings`.
void check_text(const EdsSheet& sheet, EdsFindings& findings);

}  // namespace canproof::host
