// Rules of one kind: see the table in device_info_rules.cpp.
#pragma once

#include <vector>

#include "host/datasheet/check/eds_findings.hpp"
#include "host/datasheet/check/eds_sheet.hpp"

namespace canproof::host {

/// The rules of this group.
const std::vector<EdsRule>& device_info_rules();
/// Adds what they find in the sheet.
void check_device_info(const EdsSheet& sheet, EdsFindings& findings);

}  // namespace canproof::host
