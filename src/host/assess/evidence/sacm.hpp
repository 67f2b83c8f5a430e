// SPDX-License-Identifier: Apache-2.0
// The argument in the exchange format of OMG's Structured Assurance Case Metamodel (SACM 2.0, XMI).
#pragma once

#include <string>

#include "host/assess/evidence/argument.hpp"
#include "host/assess/evidence/own_exhibits.hpp"

namespace canproof::host {

/// Returns an assurance case. It contains a SACM claim for each claim of the argument, with its limits as a note, and
/// an artifact for each piece of evidence. Inferences connect claims with claims; evidence relations connect artifacts
/// with claims. A claim that does not hold is marked as needing support; so is the relation to evidence that does not
/// hold. `version` is the commit.
std::string write_sacm(const Argument& argument, const Exhibits& exhibits, const std::string& version);

}  // namespace canproof::host
