// The argument as data and as a graph, in the notions of the Goal Structuring Notation: claims are goals, evidence are
// solutions, limits are contexts.
#pragma once

#include <string>

#include "host/assess/evidence/argument.hpp"
#include "host/assess/evidence/own_exhibits.hpp"

namespace canproof::host {

/// JSON: goals with what they support, their state, limits and solutions; solutions with state and sentence.
std::string write_argument_json(const Argument& argument, const Exhibits& exhibits);

/// The root, its claims, and below each claim its evidence as SVG markup: a box each, which is a link to it. Claims
/// further down are left out.
std::string argument_graph(const Argument& argument, const Exhibits& exhibits);

}  // namespace canproof::host
