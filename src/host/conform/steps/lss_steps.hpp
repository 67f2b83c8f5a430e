// SPDX-License-Identifier: Apache-2.0
// The steps of a conformance case that begin with lss: lss waiting, configuration, select, fastscan and inquire.
#pragma once

#include <vector>

#include "host/conform/steps/parse_steps.hpp"

namespace canproof::host::conform {

std::vector<Verb> lss_verbs();

}  // namespace canproof::host::conform
