#include "host/assess/trace/review.hpp"

#include <fmt/format.h>

#include <utility>

#include "host/register/fingerprint.hpp"

namespace canproof::host {

namespace {

/// The fingerprints of what is in force.
std::map<std::string, std::string> prints_in_force(const Part& part) {
    auto prints = fingerprints(part);
    for (const auto& requirement : part.requirements) {
        if (!requirement.retired.empty()) {
            prints.erase(requirement.id);
        }
    }
    return prints;
}

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        out += (c == '"' || c == '\\') ? std::string{'\\', c} : std::string{c};
    }
    return out + "\"";
}

}  // namespace

ReviewState::ReviewState(const Register& content) {
    for (const auto& part : content.parts) {
        now_.merge(prints_in_force(part));
        reviewed_.insert(part.reviews.begin(), part.reviews.end());
    }
}

std::string ReviewState::change_of(const std::string& id) const {
    const auto now = now_.find(id);
    const auto then = reviewed_.find(id);
    if (now == now_.end() || (then != reviewed_.end() && then->second.fingerprint == now->second)) {
        return "";
    }
    return then == reviewed_.end() ? "never reviewed" : "changed since its review of " + then->second.date;
}

std::string ReviewState::suspicion(const std::string& id, const std::vector<std::string>& decisions) const {
    if (const std::string own = change_of(id); !own.empty()) {
        return own;
    }
    for (const auto& decision : decisions) {
        if (const std::string change = change_of(decision); !change.empty()) {
            return fmt::format("{}, which affects it, {}", decision, change);
        }
    }
    return "";
}

std::string write_reviews(const Part& part, const std::set<std::string>& ids, const std::string& date,
                          const std::string& by) {
    std::map<std::pair<std::string, std::string>, std::map<std::string, std::string>> blocks;
    for (const auto& [id, print] : prints_in_force(part)) {
        if (ids.count(id) != 0) {
            blocks[{date, by}][id] = print;
        } else if (const auto old = part.reviews.find(id); old != part.reviews.end()) {
            blocks[{old->second.date, old->second.by}][id] = old->second.fingerprint;
        }
    }
    std::string text = "# Written by `canproof spec review`: who read which items, as they were then, when.\n";
    for (const auto& [session, prints] : blocks) {
        text += fmt::format("\n[[review]]\ndate = {}\nby = {}\n[review.items]\n", quoted(session.first),
                            quoted(session.second));
        for (const auto& [id, print] : prints) {
            text += fmt::format("{} = \"{}\"\n", id, print);
        }
    }
    return text;
}

std::set<std::string> reviewable(const Part& part) {
    std::set<std::string> ids;
    for (const auto& [id, print] : prints_in_force(part)) {
        ids.insert(id);
    }
    return ids;
}

std::set<std::string> unreviewed(const Part& part) {
    std::set<std::string> ids;
    for (const auto& [id, print] : prints_in_force(part)) {
        const auto found = part.reviews.find(id);
        if (found == part.reviews.end() || found->second.fingerprint != print) {
            ids.insert(id);
        }
    }
    return ids;
}

}  // namespace canproof::host
