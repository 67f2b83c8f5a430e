// SPDX-License-Identifier: Apache-2.0
// Rules for the spelling of lines, sections and keys in an EDS. text_rules.cpp contains the table of these rules.
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
