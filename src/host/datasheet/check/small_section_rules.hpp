// SPDX-License-Identifier: Apache-2.0
// Rules for [Comments], [DummyUsage] and keys of device configuration files. small_section_rules.cpp contains the table
// of these rules.
#pragma once

#include <vector>

#include "host/datasheet/check/eds_findings.hpp"
#include "host/datasheet/check/eds_sheet.hpp"

namespace canproof::host {

/// Returns the rules for the small sections, such as [Comments].
const std::vector<EdsRule>& small_section_rules();
/// Checks the sheet against these rules and adds each violation to `findings`.
void check_small_section(const EdsSheet& sheet, EdsFindings& findings);

}  // namespace canproof::host
