// SPDX-License-Identifier: Apache-2.0
// Derives the state of a technique of a standard from the exhibits (results of tools) on which it rests.
#pragma once

#include <vector>

#include "host/assess/evidence/argument.hpp"
#include "host/assess/evidence/own_exhibits.hpp"

namespace canproof::host {

/// Returns the techniques with the states that the exhibits of this pack permit. A technique that is `shown` or
/// `partly` keeps its state only while each exhibit that it names holds. Otherwise its state is the worst state of
/// these exhibits: `not measured`, `stale` or `open`; the text of the technique then names the exhibit.
std::vector<Technique> techniques_of(const Argument& argument, const Exhibits& exhibits);

}  // namespace canproof::host
