// SPDX-License-Identifier: Apache-2.0
// The argument as data and as a graph, in the terms of the Goal Structuring Notation: a claim is a goal, evidence is a
// solution, and limits are a context.
#pragma once

#include <string>

#include "host/assess/evidence/argument.hpp"
#include "host/assess/evidence/own_exhibits.hpp"

namespace canproof::host {

/// Returns JSON: goals with parent, state, limits and solutions; each solution with its state and the sentence about
/// its result.
std::string write_argument_json(const Argument& argument, const Exhibits& exhibits);

/// Returns SVG markup of the top claim, the claims directly below it, and their evidence. The box of a claim links to
/// the claim; the box of evidence links to its page, if there is one. Deeper claims are left out.
std::string argument_graph(const Argument& argument, const Exhibits& exhibits);

}  // namespace canproof::host
