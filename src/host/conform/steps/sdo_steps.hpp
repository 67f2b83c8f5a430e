// SPDX-License-Identifier: Apache-2.0
// The steps of a conformance case that begin with read, write, try or block.
#pragma once

#include <vector>

#include "host/conform/steps/parse_steps.hpp"

namespace canproof::host::conform {

std::vector<Verb> sdo_verbs();

}  // namespace canproof::host::conform
