// Reviews: whether an item, its code and its tests are still what someone read together.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "host/assess/source/item_work.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Who reads, when, and whether they made the change themselves.
struct ReviewSession {
    std::string date;  ///< 2026-11-21
    std::string by;
    std::string role;     ///< author or independent
    bool wording{false};  ///< the items alone were read; their code and tests are marked as they are
};

class ReviewState {
  public:
    /// `work` must outlive it.
    ReviewState(const Register& content, const WorkByItem& work);

    /// Empty when the item, its code, its tests and these decisions, which affect it, are as they were reviewed.
    std::string suspicion(const std::string& id, const std::vector<std::string>& decisions) const;

  private:
    std::string change_of(const std::string& id) const;
    std::string change_of_work(const std::string& id) const;

    std::map<std::string, std::string> now_;  ///< fingerprints
    std::map<std::string, Review> reviewed_;
    const WorkByItem& work_;
};

/// `spec/devices/NAME/reviews.toml` with these ids reviewed in a session, the part's other reviews kept; those of
/// retired or vanished items are left out.
std::string write_reviews(const Part& part, const std::set<std::string>& ids, const ReviewSession& session,
                          const WorkByItem& work);

/// The same file with the marks of code and tests as they are now in each review of an item whose text and decisions
/// have not changed. `date` says when; who, when and in which role stays. It does not say that anybody has read them.
std::string write_marked_reviews(const Part& part, const std::string& date, const WorkByItem& work);

/// Ids of the part, decisions too, that are in force.
std::set<std::string> reviewable(const Part& part);
/// Those of them that have no review of what they, their code and their tests say now.
std::set<std::string> unreviewed(const Part& part, const WorkByItem& work);

/// Items and decisions in force with a review of today's state: by authors of the change, by others, and by people who
/// did not say.
struct ReviewCounts {
    std::size_t author{0};
    std::size_t independent{0};
    std::size_t unsaid{0};
    std::size_t marked{0};  ///< of all of them: code and tests were marked, not read
};
ReviewCounts count_reviews(const Part& part, const WorkByItem& work);

}  // namespace canproof::host
