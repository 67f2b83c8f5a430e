// SPDX-License-Identifier: Apache-2.0
// Notes on pages: who reviewed a decision, a hazard or the classification of a manual's section (normative or not).
#pragma once

#include <string>

#include "host/assess/evidence/pack_input.hpp"
#include "host/assess/trace/review.hpp"

namespace canproof::host {

class ReviewNotes {
  public:
    /// Keeps a reference to `work`, which must outlive the object.
    ReviewNotes(const Register& content, const WorkByItem& work);
    /// Keeps a reference to the evidence in `input`, which must outlive the object.
    explicit ReviewNotes(const PackInput& input);

    /// Returns a paragraph of markup that shows on screens only: reader, date and role of the review of `id` in `part`,
    /// or the reason why this review no longer counts. After an author's review, it also states whether there is an
    /// independent review.
    std::string of(const Part& part, const std::string& id) const;

    /// Returns plain text about the independent review of `id`, to append to the words on the review in `part`: for
    /// example `; no independent review`, or that the independent review has expired. Returns an empty text when `part`
    /// has no review of `id`, or when this review is the independent one and has not expired.
    std::string beside(const Part& part, const std::string& id) const;

  private:
    ReviewState state_;
};

}  // namespace canproof::host
