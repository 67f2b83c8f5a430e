// SPDX-License-Identifier: Apache-2.0
#include "host/register/read_review.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <optional>
#include <sstream>
#include <utility>

#include "host/register/written_form.hpp"

namespace canproof::host {

namespace {

/// Parses the hashes of a review, `ITEM CODE TESTS`. `-` or a missing hash means that there was no code or no test.
/// Returns nothing for any other text.
std::optional<Review> read_marks(const std::string& marks) {
    std::istringstream words{marks};
    Review review;
    std::string rest;
    words >> review.fingerprint >> review.code >> review.tests >> rest;
    bool sound = is_hash(review.fingerprint) && rest.empty();
    for (std::string* mark : {&review.code, &review.tests}) {
        if (*mark == "-") {
            mark->clear();
        }
        sound = sound && (mark->empty() || is_hash(*mark));
    }
    return sound ? std::optional{review} : std::nullopt;
}

/// Checks the dates of a review: of the day of reading, and of the day on which hashes were renewed without a reader.
void check_dates(TomlItem& item) {
    for (const char* key : {"date", "marked"}) {
        const std::string date = item.text_or(key, "");
        if (!date.empty() && !is_date(date)) {
            item.fault(item.place(key), fmt::format("{} {} is no date", key, date), "write YYYY-MM-DD");
        }
    }
}

/// Adds the review of an item. An item may have two reviews: the author's, and an earlier one by an independent reader.
/// Returns false for any other second review.
bool add_review(Part& part, const std::string& id, Review review) {
    const auto found = part.reviews.find(id);
    if (found == part.reviews.end()) {
        part.reviews.emplace(id, std::move(review));
        return true;
    }
    Review& first = found->second;
    const bool is_independent = review.role == "independent";
    if (is_independent == (first.role == "independent")) {
        return false;
    }
    if (!is_independent) {
        std::swap(first, review);
    }
    return part.independent_reviews.emplace(id, std::move(review)).second;
}

}  // namespace

void read_review(TomlItem& item, Part& part) {
    const std::string date = item.text("date");
    const std::string by = item.text("by");
    const std::string role = item.text_or("role", "");
    if (!role.empty() && role != "author" && role != "independent") {
        item.fault(fmt::format("role `{}` is unknown", role), "write `author` (of the change) or `independent`");
    }
    const std::string marked = item.text_or("marked", "");
    check_dates(item);
    if (auto items = item.item("items")) {
        for (const auto& [key, print] : items->table()) {
            const std::string id{key.str()};
            const Place place = items->place(id);
            const auto marks = read_marks(to_text(literal(print)));
            if (!marks) {
                item.fault(place, fmt::format("the hashes of {} are malformed", id),
                           "record the review with `canproof spec review`, which writes ITEM CODE TESTS");
                continue;
            }
            Review review = *marks;
            review.date = date;
            review.by = by;
            review.role = role;
            review.marked = marked;
            review.place = place;
            if (!add_review(part, id, std::move(review))) {
                item.fault(place, fmt::format("{} is reviewed twice", id), "keep the later review");
            }
        }
    } else {
        item.fault("the review has no items", "write [review.items] with `ID = \"ITEM CODE TESTS\"` lines");
    }
    item.finish();
}

}  // namespace canproof::host
