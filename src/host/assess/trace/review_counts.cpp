// SPDX-License-Identifier: Apache-2.0
#include "host/assess/trace/review_counts.hpp"

#include <string>

namespace canproof::host {

namespace {

/// Adds an item to `counts` by the state of its independent review: valid, of the text only, expired or missing.
void add_independent(ReviewCounts& counts, const IndependentReview& review) {
    using Covers = IndependentReview::Covers;
    ++(review.review == nullptr         ? counts.not_independent
       : review.covers == Covers::whole ? counts.independent
       : review.covers == Covers::text  ? counts.independent_text
                                        : counts.expired);
}

/// Counts the review of `id` if it is current and its reader is the author or has no recorded role.
void add_author(ReviewCounts& counts, const ReviewState& state, const std::string& id, const Review& review) {
    if (review.role == "independent" || !state.is_current(id, review)) {
        return;
    }
    ++(review.role.empty() ? counts.unsaid : state.covers_work(id, review) ? counts.author : counts.author_text);
}

}  // namespace

ReviewCounts& ReviewCounts::operator+=(const ReviewCounts& other) {
    in_force += other.in_force;
    independent += other.independent;
    independent_text += other.independent_text;
    expired += other.expired;
    not_independent += other.not_independent;
    author += other.author;
    author_text += other.author_text;
    unsaid += other.unsaid;
    return *this;
}

std::map<ReviewedKind, ReviewCounts> count_reviews(const Register& content, const Part& part,
                                                   const ReviewState& state) {
    std::map<std::string, ReviewedKind> known_kinds;
    for (const auto& decision : part.decisions) {
        known_kinds[decision.id] = ReviewedKind::decision;
    }
    for (const auto& hazard : part.hazards) {
        known_kinds[hazard.id] = ReviewedKind::hazard;
    }
    std::map<ReviewedKind, ReviewCounts> counts;
    for (const auto& id : reviewable(content, part)) {
        const auto known = known_kinds.find(id);
        const bool is_section = id.find(':') != std::string::npos;  // only the ids of sections contain a colon
        const auto kind = known != known_kinds.end() ? known->second
                          : is_section               ? ReviewedKind::disposition
                                                     : ReviewedKind::item;
        ReviewCounts& one = counts[kind];
        ++one.in_force;
        add_independent(one, state.independent(part, id));
        if (const auto review = part.reviews.find(id); review != part.reviews.end()) {
            add_author(one, state, id, review->second);
        }
    }
    return counts;
}

}  // namespace canproof::host
