// SPDX-License-Identifier: Apache-2.0
// The steps of a conformance case that begin with choose, each, for, repeat, while, if, check, skip, note, fail, do,
// return, next, let or eds.
#pragma once

#include <vector>

#include "host/conform/steps/parse_steps.hpp"

namespace canproof::host::conform {

std::vector<Verb> flow_verbs();

}  // namespace canproof::host::conform
