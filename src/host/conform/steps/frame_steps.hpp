// SPDX-License-Identifier: Apache-2.0
// The verbs send, expect, await, sdo, answer, abort, clear, produce, traffic, wait.
#pragma once

#include <vector>

#include "host/conform/steps/parse_steps.hpp"

namespace canproof::host::conform {

std::vector<Verb> frame_verbs();

}  // namespace canproof::host::conform
