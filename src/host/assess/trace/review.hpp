// Reviews: whether what an item says is still what someone read together with its code and tests.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

class ReviewState {
  public:
    explicit ReviewState(const Register& content);

    /// Empty when the item and these decisions, which affect it, are as they were reviewed.
    std::string suspicion(const std::string& id, const std::vector<std::string>& decisions) const;

  private:
    std::string change_of(const std::string& id) const;

    std::map<std::string, std::string> now_;  ///< fingerprints
    std::map<std::string, Review> reviewed_;
};

/// `spec/devices/NAME/reviews.toml` with these ids reviewed by someone on a date, the part's other reviews kept; those
/// of retired or vanished items are left out.
std::string write_reviews(const Part& part, const std::set<std::string>& ids, const std::string& date,
                          const std::string& by);

/// Ids of the part, decisions too, that are in force.
std::set<std::string> reviewable(const Part& part);
/// Those of them that have no review of what they say now.
std::set<std::string> unreviewed(const Part& part);

}  // namespace canproof::host
