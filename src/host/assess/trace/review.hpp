// SPDX-License-Identifier: Apache-2.0
// Reviews: whether an item, its code and its tests still have the form in which someone reviewed them.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "host/assess/source/item_work.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// The reviewer, the date, and whether the reviewer made the change.
struct ReviewSession {
    std::string date;  ///< 2026-11-21
    std::string by;
    std::string role;     ///< author or independent
    bool wording{false};  ///< only the items were read; the marks of code and tests are the present ones
};

class ReviewState {
  public:
    /// `work` must outlive the object.
    ReviewState(const Register& content, const WorkByItem& work);

    /// Returns the reason why an item is suspect. Empty when the item, its code, its tests and these decisions, which
    /// affect it, are unchanged since the review.
    std::string suspicion(const std::string& id, const std::vector<std::string>& decisions) const;

  private:
    std::string change_of(const std::string& id) const;
    std::string change_of_work(const std::string& id) const;

    std::map<std::string, std::string> now_;  ///< fingerprints
    std::map<std::string, Review> reviewed_;
    const WorkByItem& work_;
};

/// Returns the text of `spec/devices/NAME/reviews.toml`. The items `ids` have the review of this session; the part's
/// other reviews stay. Reviews of retired or removed items are left out.
std::string write_reviews(const Part& part, const std::set<std::string>& ids, const ReviewSession& session,
                          const WorkByItem& work);

/// Returns the text of the same file with the present marks of code and tests, for each review of an item whose text
/// and decisions are unchanged. `date` is the date of the marks. Reviewer, review date and role stay; the new marks are
/// no claim that someone has read the code.
std::string write_marked_reviews(const Part& part, const std::string& date, const WorkByItem& work);

/// Returns date, reader, role and what was read: `2026-11-21 by NAME, author of the change; read: item, code, tests`.
std::string review_words(const Review& review);

/// Returns the ids of the part's items and decisions that are in force.
std::set<std::string> reviewable(const Part& part);
/// Returns those of them whose item, code and tests in their present form have no review.
std::set<std::string> unreviewed(const Part& part, const WorkByItem& work);

/// Number of items and decisions in force with a current review: by authors of the change, by others, and by reviewers
/// without a stated role.
struct ReviewCounts {
    std::size_t author{0};
    std::size_t independent{0};
    std::size_t unsaid{0};
    std::size_t marked{0};  ///< number of all these whose code and tests were marked but not read
};
ReviewCounts count_reviews(const Part& part, const WorkByItem& work);

}  // namespace canproof::host
