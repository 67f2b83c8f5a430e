// SPDX-License-Identifier: Apache-2.0
// Reviews: whether an item with its code and tests, or the classification of a manual's section, still has the form in
// which someone reviewed it.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "host/assess/source/item_work.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// One review session: the reviewer, the date, and whether the reviewer is the author of the change.
struct ReviewSession {
    std::string date;  ///< 2026-11-21
    std::string by;
    std::string role;  ///< author or independent
    /// only the text of the items was read; the recorded hashes of code and tests are those of the present code
    bool wording{false};
};

/// The latest review of an item by an independent reader, and how much of the item it covers in its present form.
struct IndependentReview {
    enum class Covers { nothing, text, whole };

    const Review* review{nullptr};  ///< nullptr: no independent reader has reviewed the item
    Covers covers{Covers::nothing};
    std::string change;  ///< reason why the review has expired; empty when it has not
};

class ReviewState {
  public:
    /// Keeps a reference to `work`, which must outlive the object.
    ReviewState(const Register& content, const WorkByItem& work);

    /// Returns the reason why an item is suspect. Returns an empty text when the item, its code, its tests and the
    /// decisions that affect it are unchanged since the review. `decisions` are the ids of these decisions.
    std::string suspicion(const std::string& id, const std::vector<std::string>& decisions) const;

    /// Returns the independent review of an item, decision, hazard or section of `part`. The pointer in the result
    /// points into `part`.
    IndependentReview independent(const Part& part, const std::string& id) const;

    /// Returns whether this review of `id` was made with the item, its code and its tests in their present form.
    bool is_current(const std::string& id, const Review& review) const;
    /// Returns whether the reader of this review read the complete item `id`: also its code and tests, if it has any.
    bool covers_work(const std::string& id, const Review& review) const;

  private:
    std::string change_of(const std::string& id, const Review* then) const;
    std::string change_of_work(const std::string& id, const Review& then) const;
    const Review* reviewed(const std::string& id) const;

    std::map<std::string, std::string> now_;  ///< present fingerprint of each item, decision, hazard and section by id
    std::map<std::string, Review> reviewed_;
    const WorkByItem& work_;
};

/// Returns the new text of `spec/devices/NAME/reviews.toml`. It contains this session's review for the items and
/// sections `ids`, and the earlier reviews of the part's other items and sections. A review by an author does not
/// replace an earlier independent review of the item; an independent review replaces every earlier one. The text leaves
/// out reviews of retired or removed items and of removed sections. In this function and in those below, `part` must
/// belong to `content`.
std::string write_reviews(const Register& content, const Part& part, const std::set<std::string>& ids,
                          const ReviewSession& session, const WorkByItem& work);

/// Returns the text of reviews.toml with the present review marks (hashes of code and tests) for each review of an item
/// or decision that is itself unchanged. `date` is the date of the new marks. Reviewer, review date and role stay. A
/// new mark does not mean that someone has read the code.
std::string write_marked_reviews(const Register& content, const Part& part, const std::string& date,
                                 const WorkByItem& work);

/// Returns date, reader, role and what was read: `2026-11-21 by NAME, author of the change; read: item, code, tests`.
std::string review_words(const Review& review);
/// Returns date, reader and role: `2026-11-21 by NAME, author of the change`.
std::string reader_words(const Review& review);
/// Returns the words about the independent review that a page adds to the review `shown`: that it is missing, has
/// expired or still counts. Returns an empty text when `shown` is itself the independent review.
std::string independent_words(const IndependentReview& independent, const Review& shown);

/// Returns the ids of the items, decisions and hazards of a part (a device, or the shared rules) that are not retired,
/// and of the sections of its manual.
std::set<std::string> reviewable(const Register& content, const Part& part);
/// Returns the ids of reviewable() without an up-to-date review: of the item with its present code and tests, or of the
/// section's present classification (normative or not).
std::set<std::string> unreviewed(const Register& content, const Part& part, const WorkByItem& work);

}  // namespace canproof::host
