// SPDX-License-Identifier: Apache-2.0
#include "host/assess/trace/review.hpp"

#include <fmt/format.h>

#include <tuple>
#include <utility>

#include "host/register/fingerprint.hpp"
#include "host/register/toml_string.hpp"

namespace canproof::host {

namespace {

using Prints = std::map<std::string, std::string>;

/// Returns the fingerprints (hashes), by id, of the items, decisions and hazards of a part (a device, or the shared
/// rules) that are not retired.
Prints prints_in_force(const Part& part) {
    auto prints = fingerprints(part);
    for (const auto& requirement : part.requirements) {
        if (!requirement.retired.empty()) {
            prints.erase(requirement.id);
        }
    }
    return prints;
}

/// Returns the fingerprints (hashes), by id, of the sections of the part's manual. Returns nothing for a part without a
/// manual.
Prints section_prints(const Register& content, const Part& part) {
    const Manual* manual = content.manual(part.info.manual);
    return manual == nullptr ? Prints{} : fingerprints(*manual);
}

/// Returns the fingerprints (hashes), by id, of all items, decisions, hazards and manual sections of the part, which
/// all need a review.
Prints all_prints(const Register& content, const Part& part) {
    Prints prints = prints_in_force(part);
    prints.merge(section_prints(content, part));
    return prints;
}

ItemWork work_of(const std::string& id, const WorkByItem& work) {
    const auto found = work.find(id);
    return found == work.end() ? ItemWork{} : found->second;
}

/// Returns the hashes of a review as reviews.toml has them: `ITEM CODE TESTS`, with `-` for no code or no tests.
/// Returns only ITEM when there are neither code nor tests.
std::string marks_of(const std::string& item, const std::string& code, const std::string& tests) {
    if (code.empty() && tests.empty()) {
        return item;
    }
    return fmt::format("{} {} {}", item, code.empty() ? "-" : code, tests.empty() ? "-" : tests);
}

bool is_of_today(const Review& review, const std::string& print, const ItemWork& now) {
    return review.fingerprint == print && review.code == now.code && review.tests == now.tests;
}

/// Returns the id as a key of TOML. Ids of sections contain a colon, and some contain blanks.
std::string toml_key(const std::string& id) {
    return id.find(':') == std::string::npos ? id : toml_string(id);
}

using Reviews = std::map<std::string, Review>;

/// Returns the text of reviews.toml with one block for each review session (reviewer, date and role). `earlier`
/// contains the independent reviews of items that an author has reviewed later.
std::string text_of(const Reviews& reviews, const Reviews& earlier) {
    using Head = std::tuple<std::string, std::string, std::string, std::string>;
    std::map<Head, std::map<std::string, std::string>> blocks;
    for (const auto* some : {&reviews, &earlier}) {
        for (const auto& [id, one] : *some) {
            blocks[{one.date, one.by, one.role, one.marked}][id] = marks_of(one.fingerprint, one.code, one.tests);
        }
    }
    std::string text =
        "# Written by `canproof spec review`. Each [[review]] has a date, a reader, and the items that were read with "
        "their code and tests.\n";
    for (const auto& [head, items] : blocks) {
        const auto& [date, by, role, marked] = head;
        text += fmt::format("\n[[review]]\ndate = {}\nby = {}\n", toml_string(date), toml_string(by));
        text += role.empty() ? "" : fmt::format("role = {}\n", toml_string(role));
        text += marked.empty() ? "" : fmt::format("marked = {}\n", toml_string(marked));
        text += "[review.items]\n";
        for (const auto& [id, marks] : items) {
            text += fmt::format("{} = \"{}\"\n", toml_key(id), marks);
        }
    }
    return text;
}

/// Returns the latest independent review of `id`; null when there is none.
const Review* independent_review(const Part& part, const std::string& id) {
    const auto shown = part.reviews.find(id);
    if (shown != part.reviews.end() && shown->second.role == "independent") {
        return &shown->second;
    }
    const auto earlier = part.independent_reviews.find(id);
    return earlier == part.independent_reviews.end() ? nullptr : &earlier->second;
}

}  // namespace

ReviewState::ReviewState(const Register& content, const WorkByItem& work) : work_{work} {
    for (const auto& part : content.parts) {
        now_.merge(all_prints(content, part));
        reviewed_.insert(part.reviews.begin(), part.reviews.end());
    }
}

const Review* ReviewState::reviewed(const std::string& id) const {
    const auto found = reviewed_.find(id);
    return found == reviewed_.end() ? nullptr : &found->second;
}

std::string ReviewState::change_of(const std::string& id, const Review* then) const {
    const auto now = now_.find(id);
    if (now == now_.end() || (then != nullptr && then->fingerprint == now->second)) {
        return "";
    }
    return then == nullptr ? "never reviewed" : "changed since its review of " + then->date;
}

std::string ReviewState::change_of_work(const std::string& id, const Review& then) const {
    const ItemWork now = work_of(id, work_);
    const bool code = then.code != now.code;
    const bool tests = then.tests != now.tests;
    if (!code && !tests) {
        return "";
    }
    return fmt::format("its {} changed since its review of {}",
                       code && tests ? "code and its tests have"
                       : code        ? "code has"
                                     : "tests have",
                       then.date);
}

std::string ReviewState::suspicion(const std::string& id, const std::vector<std::string>& decisions) const {
    const Review* const then = reviewed(id);
    if (const std::string own = change_of(id, then); !own.empty()) {
        return own;
    }
    if (const std::string work = then == nullptr ? "" : change_of_work(id, *then); !work.empty()) {
        return work;
    }
    for (const auto& decision : decisions) {
        if (const std::string change = change_of(decision, reviewed(decision)); !change.empty()) {
            return fmt::format("{}, which affects this item, {}", decision, change);
        }
    }
    return "";
}

bool ReviewState::is_current(const std::string& id, const Review& review) const {
    return change_of(id, &review).empty() && change_of_work(id, review).empty();
}

bool ReviewState::covers_work(const std::string& id, const Review& review) const {
    const ItemWork now = work_of(id, work_);
    return review.marked.empty() || (now.code.empty() && now.tests.empty());
}

IndependentReview ReviewState::independent(const Part& part, const std::string& id) const {
    IndependentReview found;
    found.review = independent_review(part, id);
    if (found.review == nullptr) {
        return found;
    }
    found.change = change_of(id, found.review);
    if (found.change.empty()) {
        found.change = change_of_work(id, *found.review);
    }
    if (found.change.empty()) {
        found.covers =
            covers_work(id, *found.review) ? IndependentReview::Covers::whole : IndependentReview::Covers::text;
    }
    return found;
}

std::string write_reviews(const Register& content, const Part& part, const std::set<std::string>& ids,
                          const ReviewSession& session, const WorkByItem& work) {
    Reviews reviews;
    Reviews earlier;
    for (const auto& [id, print] : all_prints(content, part)) {
        if (ids.count(id) != 0) {
            const ItemWork now = work_of(id, work);
            reviews[id] = {
                print, now.code, now.tests, session.date, session.by, session.role, session.wording ? session.date : "",
                {}};
        } else if (const auto old = part.reviews.find(id); old != part.reviews.end()) {
            reviews[id] = old->second;
        }
        const Review* const independent = independent_review(part, id);
        if (independent != nullptr && reviews[id].role != "independent") {
            earlier[id] = *independent;
        }
    }
    return text_of(reviews, earlier);
}

std::string write_marked_reviews(const Register& content, const Part& part, const std::string& date,
                                 const WorkByItem& work) {
    Reviews reviews;
    Reviews earlier;
    for (const auto& [id, print] : all_prints(content, part)) {
        const auto old = part.reviews.find(id);
        if (old == part.reviews.end()) {
            continue;
        }
        Review& kept = reviews[id] = old->second;
        if (const ItemWork now = work_of(id, work); kept.fingerprint == print && !is_of_today(kept, print, now)) {
            kept.code = now.code;
            kept.tests = now.tests;
            kept.marked = date;
        }
        if (const auto found = part.independent_reviews.find(id); found != part.independent_reviews.end()) {
            earlier[id] = found->second;
        }
    }
    return text_of(reviews, earlier);
}

std::set<std::string> reviewable(const Register& content, const Part& part) {
    std::set<std::string> ids;
    for (const auto& [id, print] : all_prints(content, part)) {
        ids.insert(id);
    }
    return ids;
}

std::set<std::string> unreviewed(const Register& content, const Part& part, const WorkByItem& work) {
    std::set<std::string> ids;
    for (const auto& [id, print] : all_prints(content, part)) {
        const auto found = part.reviews.find(id);
        if (found == part.reviews.end() || !is_of_today(found->second, print, work_of(id, work))) {
            ids.insert(id);
        }
    }
    return ids;
}

std::string reader_words(const Review& review) {
    // some recorded names contain the role, which is removed from them, because the text below adds it
    const std::string role = " (author of the change)";
    const auto at = review.role == "author" ? review.by.find(role) : std::string::npos;
    const std::string by = at == std::string::npos ? review.by : std::string{review.by}.erase(at, role.size());
    return fmt::format("{} by {}{}", review.date, by,
                       review.role == "author"        ? ", author of the change"
                       : review.role == "independent" ? ", not the author of the change"
                                                      : ", role not stated");
}

std::string review_words(const Review& review) {
    if (!review.marked.empty()) {
        return fmt::format("{}; read: item; code and tests recorded on {} without reading", reader_words(review),
                           review.marked);
    }
    std::string read = "item";
    read += review.code.empty() ? "" : ", code";
    read += review.tests.empty() ? "" : ", tests";
    return fmt::format("{}; read: {}", reader_words(review), read);
}

std::string independent_words(const IndependentReview& independent, const Review& shown) {
    if (independent.review == nullptr) {
        return "no independent review";
    }
    if (!independent.change.empty()) {
        return fmt::format("independent review by {} has expired: {}", independent.review->by, independent.change);
    }
    return independent.review == &shown ? "" : "also reviewed " + review_words(*independent.review);
}

}  // namespace canproof::host
