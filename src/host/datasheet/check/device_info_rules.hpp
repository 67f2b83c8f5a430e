// SPDX-License-Identifier: Apache-2.0
// Rules for the section [DeviceInfo] of an EDS. device_info_rules.cpp contains the table of these rules.
#pragma once

#include <vector>

#include "host/datasheet/check/eds_findings.hpp"
#include "host/datasheet/check/eds_sheet.hpp"

namespace canproof::host {

/// Returns the rules for [DeviceInfo].
const std::vector<EdsRule>& device_info_rules();
/// Checks the sheet against these rules and adds each violation to `findings`.
void check_device_info(const EdsSheet& sheet, EdsFindings& findings);

}  // namespace canproof::host
