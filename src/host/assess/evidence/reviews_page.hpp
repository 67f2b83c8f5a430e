// SPDX-License-Identifier: Apache-2.0
// The page of the reviews: how much of the requirements register authors and independent readers have read in its
// present form.
#pragma once

#include <map>
#include <string>

#include "host/assess/evidence/pack_input.hpp"
#include "host/assess/trace/review_counts.hpp"

namespace canproof::host {

/// Returns the counts of reviews, summed over all devices and the shared rules.
std::map<ReviewedKind, ReviewCounts> count_all_reviews(const PackInput& input);

/// Returns four sentences: for items, decisions, hazards and classified sections (normative or not). Each states how
/// many of them independent readers have read, and how many have an expired or no such review.
std::string review_sentences(const std::map<ReviewedKind, ReviewCounts>& counts);

/// Returns the body of the page: the counts of each device and of the shared rules, and each independent review that
/// has expired.
std::string reviews_page(const PackInput& input);

}  // namespace canproof::host
