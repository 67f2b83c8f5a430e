// SPDX-License-Identifier: Apache-2.0
// The argument in the exchange format of OMG's Structured Assurance Case Metamodel (SACM 2.0, XMI).
#pragma once

#include <string>

#include "host/assess/evidence/argument.hpp"
#include "host/assess/evidence/own_exhibits.hpp"

namespace canproof::host {

/// Returns an assurance case: a claim for each claim, with its limits as a note; an artifact for each piece of
/// evidence; inferences from claims to claims, and evidence from artifacts to claims. A claim that does not hold, and
/// evidence that does not, need support. `version` is the commit.
std::string write_sacm(const Argument& argument, const Exhibits& exhibits, const std::string& version);

}  // namespace canproof::host
