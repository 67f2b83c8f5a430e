// SPDX-License-Identifier: Apache-2.0
// Counts who has read the items of a device, or of the shared rules, in their present form: the author of the change,
// or an independent reader.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "host/assess/trace/review.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// The kinds of things that a reader reviews; a disposition says whether a section of a manual is normative.
enum class ReviewedKind { item, decision, hazard, disposition };

/// Numbers of items (or decisions, hazards, dispositions) that are not retired, by their reviews. Each item counts in
/// exactly one of the four numbers of independent reviews. The reviews by authors are counted apart, because an item
/// may have both.
struct ReviewCounts {
    std::size_t in_force{0};
    std::size_t independent{0};       ///< read by an independent reader in the present form, with code and tests
    std::size_t independent_text{0};  ///< read by an independent reader in the present form, without code and tests
    std::size_t expired{0};           ///< read by an independent reader in an earlier form only
    std::size_t not_independent{0};   ///< never read by an independent reader
    std::size_t author{0};            ///< read by the author of the change in the present form, with code and tests
    std::size_t author_text{0};       ///< read by the author of the change in the present form, without code and tests
    std::size_t unsaid{0};            ///< read in the present form by someone whose role is not recorded

    ReviewCounts& operator+=(const ReviewCounts& other);
};

/// Counts the reviews of the items, decisions and hazards of a part (a device, or the shared rules) that are not
/// retired, and of the sections of its manual. `part` must belong to `content`.
std::map<ReviewedKind, ReviewCounts> count_reviews(const Register& content, const Part& part, const ReviewState& state);

}  // namespace canproof::host
