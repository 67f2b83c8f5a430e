// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/review_notes.hpp"

#include <fmt/format.h>

#include "host/report/markup.hpp"

namespace canproof::host {

ReviewNotes::ReviewNotes(const Register& content, const WorkByItem& work) : state_{content, work} {}

ReviewNotes::ReviewNotes(const PackInput& input) : ReviewNotes{*input.content, input.evidence.work} {}

std::string ReviewNotes::of(const Part& part, const std::string& id) const {
    const std::string suspicion = state_.suspicion(id, {});
    const auto review = part.reviews.find(id);
    const std::string words = !suspicion.empty() ? suspicion
                              : review == part.reviews.end()
                                  ? "never reviewed"
                                  : "reviewed " + reader_words(review->second) + beside(part, id);
    return fmt::format("<p class=screen><small>{}</small></p>", escaped(words));
}

std::string ReviewNotes::beside(const Part& part, const std::string& id) const {
    const auto review = part.reviews.find(id);
    const std::string words =
        review == part.reviews.end() ? "" : independent_words(state_.independent(part, id), review->second);
    return words.empty() ? "" : "; " + words;
}

}  // namespace canproof::host
