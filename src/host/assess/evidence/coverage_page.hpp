// SPDX-License-Identifier: Apache-2.0
// The coverage of the firmware, and of the host's buses and replay, as a page of the pack.
#pragma once

#include <string>

#include "host/assess/evidence/pack_input.hpp"

namespace canproof::host {

/// Returns the body of the page as markup.
std::string coverage_page(const MeasuredCoverage& coverage);

}  // namespace canproof::host
