// SPDX-License-Identifier: Apache-2.0
// The verbs silence, count, period, watch, end.
#pragma once

#include <vector>

#include "host/conform/steps/parse_steps.hpp"

namespace canproof::host::conform {

std::vector<Verb> time_verbs();

}  // namespace canproof::host::conform
