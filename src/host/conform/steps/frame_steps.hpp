// SPDX-License-Identifier: Apache-2.0
// The steps of a conformance case that begin with send, expect, await, sdo, answer, abort, clear, produce, traffic or
// wait.
#pragma once

#include <vector>

#include "host/conform/steps/parse_steps.hpp"

namespace canproof::host::conform {

std::vector<Verb> frame_verbs();

}  // namespace canproof::host::conform
