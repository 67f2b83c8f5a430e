// The coverage of the firmware, and of the host's buses and replay, as a page of the pack.
#pragma once

#include <string>

#include "host/assess/evidence/pack_input.hpp"

namespace canproof::host {

/// Markup of the body.
std::string coverage_page(const MeasuredCoverage& coverage);

}  // namespace canproof::host
