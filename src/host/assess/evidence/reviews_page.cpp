// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/reviews_page.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>
#include <vector>

#include "host/assess/evidence/item_links.hpp"
#include "host/report/markup.hpp"
#include "host/report/page.hpp"

namespace canproof::host {

namespace {

const std::array<std::pair<ReviewedKind, const char*>, 4> reviewed_kinds{
    {{ReviewedKind::item, "Items"},
     {ReviewedKind::decision, "Decisions"},
     {ReviewedKind::hazard, "Hazards"},
     {ReviewedKind::disposition, "Dispositions of sections"}}};

std::string part_title(const Part& part) {
    return part.info.title.empty() ? part.name : part.info.title;
}

std::vector<std::string> counts_row(const std::string& name, const ReviewCounts& counts) {
    std::vector<std::string> cells{escaped(name)};
    for (const auto count : {counts.in_force, counts.independent, counts.independent_text, counts.expired,
                             counts.not_independent, counts.author, counts.author_text, counts.unsaid}) {
        cells.push_back(std::to_string(count));
    }
    return cells;
}

/// Returns the table for one kind of reviewed things (items, decisions, hazards or sections), with a row for each
/// device (or the shared rules) that has such things, and a row for the sum.
std::string counts_table(const PackInput& input, const ReviewState& state, const ReviewedKind kind, const char* title) {
    std::vector<std::vector<std::string>> rows;
    ReviewCounts all;
    for (const auto& audit : input.audits) {
        const auto counts = count_reviews(*input.content, *audit.part, state);
        if (const auto found = counts.find(kind); found != counts.end()) {
            rows.push_back(counts_row(part_title(*audit.part), found->second));
            all += found->second;
        }
    }
    if (rows.empty()) {
        return "";
    }
    rows.push_back(counts_row("all", all));
    return fmt::format("<h2>{}</h2>\n", title) + html_table(fmt::format("Reviews: {}", title),
                                                            {{"Part", 24},
                                                             {"In force"},
                                                             {"Independent"},
                                                             {"Independent, text alone"},
                                                             {"Independent, expired"},
                                                             {"No independent review"},
                                                             {"Author"},
                                                             {"Author, text alone"},
                                                             {"Role not recorded"}},
                                                            rows);
}

std::string expired_table(const PackInput& input, const ReviewState& state) {
    const ItemLinks links = links_of(input);
    std::vector<std::vector<std::string>> rows;
    for (const auto& audit : input.audits) {
        for (const auto& id : reviewable(*input.content, *audit.part)) {
            const IndependentReview review = state.independent(*audit.part, id);
            if (!review.change.empty()) {
                rows.push_back(
                    {link_to_each(links, {id}), escaped(reader_words(*review.review)), escaped(review.change)});
            }
        }
    }
    if (rows.empty()) {
        return "<p>No independent review has expired.</p>\n";
    }
    return "<h2 id=expired>Independent reviews that have expired</h2>\n" +
           html_table("Independent reviews that have expired", {{"Item", 18}, {"Reader", 50}, {"What has changed", 32}},
                      rows, Search::yes);
}

/// Returns the sentence about the reviews of one kind of things. `things` is the plural name of this kind, such as
/// `decisions`.
std::string review_sentence(const ReviewCounts& counts, const char* things) {
    const std::string text_alone =
        counts.independent_text == 0 ? "" : fmt::format(", and the text alone of {}", counts.independent_text);
    return fmt::format("Independent readers have read {} of {} {}{}; their review of {} has expired, and {} have none.",
                       counts.independent, counts.in_force, things, text_alone, counts.expired, counts.not_independent);
}

}  // namespace

std::map<ReviewedKind, ReviewCounts> count_all_reviews(const PackInput& input) {
    const ReviewState state{*input.content, input.evidence.work};
    std::map<ReviewedKind, ReviewCounts> all;
    for (const auto& audit : input.audits) {
        for (const auto& [kind, counts] : count_reviews(*input.content, *audit.part, state)) {
            all[kind] += counts;
        }
    }
    return all;
}

std::string review_sentences(const std::map<ReviewedKind, ReviewCounts>& counts) {
    static const std::map<ReviewedKind, const char*> things{{ReviewedKind::item, "items with code and tests"},
                                                            {ReviewedKind::decision, "decisions"},
                                                            {ReviewedKind::hazard, "hazards"},
                                                            {ReviewedKind::disposition, "dispositions of sections"}};
    std::string text;
    for (const auto& [kind, one] : counts) {
        text += (text.empty() ? "" : " ") + review_sentence(one, things.at(kind));
    }
    return text;
}

std::string reviews_page(const PackInput& input) {
    const ReviewState state{*input.content, input.evidence.work};
    std::string text =
        "<p>A review records that a person has read an item and, where the table does not say “text alone”, its code "
        "and its tests. It expires when one of the three changes. A decision, a hazard and the disposition of a "
        "section have no code and no tests of their own. A "
        "review "
        "is independent when the reader is not the author of the change. Independent readers belong to the project "
        "too: "
        "nobody outside of it has reviewed the register.</p>\n"
        "<p>Each table counts the reviews of the present form. “Text alone” means that code or tests changed without a "
        "new "
        "reading of them. “No independent review” means that no independent reader has ever reviewed it. An item may "
        "count "
        "as "
        "“independent, expired” and as “author”: then the author has read it after the last change.</p>\n";
    for (const auto& [kind, title] : reviewed_kinds) {
        text += counts_table(input, state, kind, title);
    }
    return text + expired_table(input, state);
}

}  // namespace canproof::host
