// SPDX-License-Identifier: Apache-2.0
// The argument (claims and their evidence) as a page of the evidence pack.
#pragma once

#include <string>

#include "host/assess/evidence/argument.hpp"
#include "host/assess/evidence/exhibit.hpp"
#include "host/assess/evidence/own_exhibits.hpp"
#include "host/assess/evidence/pack_input.hpp"

namespace canproof::host {

/// Returns the claims as markup, with their evidence and the limits of that evidence.
std::string claims_markup(const Argument& argument, const Exhibits& exhibits);
/// Returns the state of a claim. A claim holds when its evidence and all claims below it hold. A claim is open when its
/// evidence or a claim below it is open, or when its evidence is stale (older than a change of its sources). Otherwise
/// some evidence is absent, and the claim is not measured.
Exhibit::State state_of_claim(const Claim& claim, const Argument& argument, const Exhibits& exhibits);
struct ClaimCounts {
    std::size_t all{0};
    std::size_t hold{0};
    std::size_t not_measured{0};
};
ClaimCounts count_claims(const Argument& argument, const Exhibits& exhibits);
/// Returns a sentence such as `7 of 9 claims hold`. If claims wait for evidence that was not measured, adds their
/// number and the command that measures it.
std::string claims_sentence(const ClaimCounts& counts);

/// Returns the body of the page as markup.
std::string argument_page(const PackInput& input, const Exhibits& exhibits);

}  // namespace canproof::host
