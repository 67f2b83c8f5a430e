// SPDX-License-Identifier: Apache-2.0
// Tests that records of reviews are written, read back, and renewed for the named items only.
#include "host/assess/trace/review.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/assess/trace/review_counts.hpp"
#include "host/register/load.hpp"
#include "host/register/spec_files.hpp"
#include "tests/host/register/small_register.hpp"
#include "tests/support/replaced.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const WorkByItem no_work;
const std::string reviews_file = "spec/devices/box/reviews.toml";

std::string items(const std::string& first, const std::string& second) {
    const char* const rest = "\"\nsource = [\"M1:1\"]\nkind = \"functional\"\nverify = [\"test\"]\n";
    return "[[requirement]]\nid = \"AO4-R-1\"\ntext = \"" + first + rest +
           "[[requirement]]\nid = \"AO4-R-2\"\ntext = \"" + second + rest;
}

Register read(const std::string& first, const std::string& second, const std::string& reviews) {
    SpecFiles files = with(items_file, items(first, second));
    if (!reviews.empty()) {
        files[reviews_file] = reviews;
    }
    const LoadResult loaded = load_register(files);
    EXPECT_FALSE(std::any_of(loaded.faults.begin(), loaded.faults.end(), [](const Fault& fault) {
        return fault.place.file == reviews_file;
    })) << all_faults(loaded);
    return loaded.content;
}

std::string reviewed(const Register& content, const std::set<std::string>& ids, const char* date, const char* by) {
    return write_reviews(content, *content.part("box"), ids, {date, by, "author", false}, {});
}

/// Returns the text of reviews.toml after `session` has reviewed AO4-R-1 of this register.
std::string after(const Register& content, const ReviewSession& session, const WorkByItem& work = {}) {
    return write_reviews(content, *content.part("box"), {"AO4-R-1"}, session, work);
}

const ReviewSession by_author{"2026-03-04", "the author", "author", false};
const ReviewSession by_reader{"2026-01-02", "a reader", "independent", false};

/// Returns what an independent reader has read of AO4-R-1.
IndependentReview independent_of(const Register& content, const WorkByItem& work = {}) {
    return ReviewState{content, work}.independent(*content.part("box"), "AO4-R-1");
}

ReviewCounts counts_of(const Register& content, const ReviewedKind kind, const WorkByItem& work = {}) {
    return count_reviews(content, *content.part("box"), ReviewState{content, work})[kind];
}

std::set<std::string> waiting(const Register& content) {
    return unreviewed(content, *content.part("box"), {});
}

/// Returns the unreviewed items without the unreviewed sections of the manual.
std::set<std::string> waiting_items(const Register& content, const WorkByItem& work = {}) {
    std::set<std::string> ids;
    for (const auto& id : unreviewed(content, *content.part("box"), work)) {
        if (id.rfind("AO4", 0) == 0) {
            ids.insert(id);
        }
    }
    return ids;
}

/// Returns the small register with a text of its manual file replaced, and with these reviews.
Register with_manual(const std::string& old_text, const std::string& new_text, const std::string& reviews) {
    SpecFiles files = with(items_file, items("a", "b"));
    files[manual_file] = replaced(files.at(manual_file), old_text, new_text);
    files[reviews_file] = reviews;
    const LoadResult loaded = load_register(files);
    EXPECT_EQ(all_faults(loaded).find("reviews.toml"), std::string::npos) << all_faults(loaded);
    return loaded.content;
}

}  // namespace

TEST(Review, AllItemsAreUnreviewedAtFirst) {
    EXPECT_THAT(waiting(read("a", "b", "")), ElementsAre("AO4-R-1", "AO4-R-2", "M1:1", "M1:2.1", "M1:Table 3"));
}

TEST(Review, ReviewIsReadBackAsWritten) {
    const std::string text = reviewed(read("a", "b", ""), {"AO4-R-1", "AO4-R-2"}, "2026-01-02", "A \"B\"");
    const Register content = read("a", "b", text);
    EXPECT_THAT(waiting_items(content), IsEmpty());
    EXPECT_EQ(content.part("box")->reviews.at("AO4-R-1").by, "A \"B\"");
    EXPECT_EQ((ReviewState{content, no_work}.suspicion("AO4-R-1", {})), "");
}

TEST(Review, ReviewOfTheTextRecordsCodeAndTestsAsNotRead) {
    const WorkByItem work{{"AO4-R-1", {"c0dec0de", "7e577e57"}}};
    const Register content = read("a", "b", "");
    const Register renewed =
        read("a", "b",
             write_reviews(content, *content.part("box"), {"AO4-R-1"}, {"2026-01-02", "one", "author", true}, work));
    const Review& review = renewed.part("box")->reviews.at("AO4-R-1");
    EXPECT_EQ(review.marked, "2026-01-02");
    EXPECT_EQ(review.code, "c0dec0de");
    EXPECT_EQ((ReviewState{renewed, work}.suspicion("AO4-R-1", {})), "");
    const Register both =
        read("a", "b",
             write_reviews(content, *content.part("box"), {"AO4-R-1"}, {"2026-01-02", "one", "author", false}, work));
    EXPECT_EQ(both.part("box")->reviews.at("AO4-R-1").marked, "");
}

TEST(Review, NewReviewChangesOnlyTheItemsThatItNames) {
    const std::string first = reviewed(read("a", "b", ""), {"AO4-R-1", "AO4-R-2"}, "2026-01-02", "one");
    const Register edited = read("a, but other", "b, but other", first);
    EXPECT_THAT(waiting_items(edited), ElementsAre("AO4-R-1", "AO4-R-2"));
    const Register again = read("a, but other", "b, but other", reviewed(edited, {"AO4-R-2"}, "2026-03-04", "two"));
    EXPECT_THAT(waiting_items(again), ElementsAre("AO4-R-1"));
    EXPECT_EQ(again.part("box")->reviews.at("AO4-R-1").date, "2026-01-02");
    EXPECT_EQ(again.part("box")->reviews.at("AO4-R-2").date, "2026-03-04");
    EXPECT_EQ((ReviewState{again, no_work}.suspicion("AO4-R-1", {})), "changed since its review of 2026-01-02");
}

TEST(Review, TwoReviewsOfOneItemWithoutAReviewRoleAreAFault) {
    const std::string block = "[[review]]\ndate = \"2026-01-02\"\nby = \"x\"\n[review.items]\nAO4-R-1 = \"00000000\"\n";
    SpecFiles files = with(items_file, items("a", "b"));
    files[reviews_file] = block + block;
    EXPECT_THAT(all_faults(load_register(files)),
                HasSubstr("spec/devices/box/reviews.toml:10: AO4-R-1 is reviewed twice; keep the later review"));
}

TEST(Review, ReviewExpiresWithTheCodeOrTestsOfItsItem) {
    const Register fresh = read("a", "b", "");
    const WorkByItem then{{"AO4-R-1", {"11111111", "22222222"}}};
    const std::string text =
        write_reviews(fresh, *fresh.part("box"), {"AO4-R-1", "AO4-R-2"}, {"2026-01-02", "x", "author"}, then);
    EXPECT_THAT(text, HasSubstr(" 11111111 22222222\"\n"));
    const Register content = read("a", "b", text);
    EXPECT_THAT(waiting_items(content, then), IsEmpty());
    const std::vector<std::pair<ItemWork, std::string>> cases{
        {{"11111111", "22222222"}, ""},
        {{"99999999", "22222222"}, "its code has changed since its review of 2026-01-02"},
        {{"11111111", "99999999"}, "its tests have changed since its review of 2026-01-02"},
        {{"", ""}, "its code and its tests have changed since its review of 2026-01-02"}};
    for (const auto& [work, sentence] : cases) {
        const WorkByItem now{{"AO4-R-1", work}};
        EXPECT_EQ((ReviewState{content, now}.suspicion("AO4-R-1", {})), sentence);
        EXPECT_EQ(waiting_items(content, now).count("AO4-R-1"), sentence.empty() ? 0U : 1U);
    }
    const WorkByItem later{{"AO4-R-1", then.at("AO4-R-1")}, {"AO4-R-2", {"", "33333333"}}};
    EXPECT_THAT((ReviewState{content, later}.suspicion("AO4-R-2", {})), HasSubstr("its tests have changed"));
}

TEST(Review, ReviewThatIsNotRenewedKeepsItsHashesOfCodeAndTests) {
    const WorkByItem work{{"AO4-R-1", {"11111111", ""}}};
    const Register first = read("a", "b", "");
    const std::string old =
        write_reviews(first, *first.part("box"), {"AO4-R-1"}, {"2026-01-02", "x", "independent"}, work);
    const Register second = read("a", "b", old);
    const Register third =
        read("a", "b", write_reviews(second, *second.part("box"), {"AO4-R-2"}, {"2026-03-04", "y", "author"}, {}));
    const Review& kept = third.part("box")->reviews.at("AO4-R-1");
    EXPECT_EQ(kept.code, "11111111");
    EXPECT_EQ(kept.tests, "");
    EXPECT_EQ(kept.role, "independent");
}

TEST(Review, RecordingNewHashesOfCodeAndTestsDoesNotCountAsReadingThem) {
    const Register first = read("a", "b", "");
    const std::string old =
        write_reviews(first, *first.part("box"), {"AO4-R-1", "AO4-R-2"}, {"2026-01-02", "x", "author"}, {});
    const WorkByItem work{{"AO4-R-1", {"11111111", "22222222"}}, {"AO4-R-2", {"33333333", ""}}};
    const Register edited = read("a, but other", "b", old);
    const Register marked =
        read("a, but other", "b", write_marked_reviews(edited, *edited.part("box"), "2026-03-04", work));
    const Review& kept = marked.part("box")->reviews.at("AO4-R-2");
    EXPECT_EQ(kept.date + kept.by + kept.role, "2026-01-02xauthor");
    EXPECT_EQ(kept.marked, "2026-03-04");
    EXPECT_EQ((ReviewState{marked, work}.suspicion("AO4-R-2", {})), "");
    EXPECT_EQ((ReviewState{marked, work}.suspicion("AO4-R-1", {})), "changed since its review of 2026-01-02");
    const ReviewCounts counts = counts_of(marked, ReviewedKind::item, work);
    EXPECT_EQ(counts.author_text, 1U);
    EXPECT_EQ(counts.author, 0U) << "AO4-R-1 has changed, and nobody has read the code of AO4-R-2";
}

TEST(Review, CurrentReviewsAreCountedByRole) {
    const Register first = read("a", "b", "");
    const std::string one =
        write_reviews(first, *first.part("box"), {"AO4-R-1"}, {"2026-01-02", "x", "independent"}, {});
    const Register second = read("a", "b", one);
    const std::string both = write_reviews(second, *second.part("box"), {"AO4-R-2"}, {"2026-01-02", "y", "author"}, {});
    const ReviewCounts counts = counts_of(read("a", "b", both), ReviewedKind::item);
    EXPECT_EQ(counts.in_force, 2U);
    EXPECT_EQ(counts.independent, 1U);
    EXPECT_EQ(counts.not_independent, 1U);
    EXPECT_EQ(counts.author, 1U);
    EXPECT_EQ(counts.unsaid, 0U);
    const ReviewCounts edited = counts_of(read("a, but other", "b", both), ReviewedKind::item);
    EXPECT_EQ(edited.independent, 0U);
    EXPECT_EQ(edited.expired, 1U);
}

TEST(Review, AuthorsReviewKeepsAnEarlierIndependentReview) {
    const Register first = read("a", "b", "");
    const Register reader = read("a", "b", after(first, by_reader));
    const Register both =
        read("a, but other", "b", after(read("a, but other", "b", after(first, by_reader)), by_author));
    EXPECT_EQ(independent_of(first).review, nullptr);
    EXPECT_EQ(independent_words(independent_of(first), {}), "no independent review");
    EXPECT_EQ(independent_of(reader).covers, IndependentReview::Covers::whole);
    EXPECT_EQ(independent_words(independent_of(reader), reader.part("box")->reviews.at("AO4-R-1")), "");
    const Review& shown = both.part("box")->reviews.at("AO4-R-1");
    EXPECT_EQ(shown.by, "the author");
    EXPECT_EQ((ReviewState{both, no_work}.suspicion("AO4-R-1", {})), "") << "the author has read the present text";
    EXPECT_EQ(independent_words(independent_of(both), shown),
              "independent review by a reader has expired: changed since its review of 2026-01-02");
    const ReviewCounts counts = counts_of(both, ReviewedKind::item);
    EXPECT_EQ(counts.author, 1U);
    EXPECT_EQ(counts.independent, 0U);
    EXPECT_EQ(counts.expired, 1U);
    EXPECT_EQ(counts.not_independent, 1U) << "AO4-R-2";
}

TEST(Review, IndependentReviewIsKeptUntilTheNextIndependentReview) {
    const Register reader = read("a", "b", after(read("a", "b", ""), by_reader));
    const Register once = read("a", "b", after(reader, by_author));
    EXPECT_EQ(independent_words(independent_of(once), once.part("box")->reviews.at("AO4-R-1")),
              "also reviewed 2026-01-02 by a reader, not the author of the change; read: item");
    const Register twice = read("a", "b", after(once, {"2026-05-06", "the author", "author", false}));
    EXPECT_EQ(twice.part("box")->reviews.at("AO4-R-1").date, "2026-05-06");
    ASSERT_NE(independent_of(twice).review, nullptr);
    EXPECT_EQ(independent_of(twice).review->date, "2026-01-02");
    const Register other_item =
        read("a", "b", write_reviews(twice, *twice.part("box"), {"AO4-R-2"}, by_author, no_work));
    ASSERT_NE(independent_of(other_item).review, nullptr);
    const Register marked = read("a", "b", write_marked_reviews(twice, *twice.part("box"), "2026-07-08", no_work));
    ASSERT_NE(independent_of(marked).review, nullptr);
    const Register again = read("a", "b", after(twice, {"2026-07-08", "a second reader", "independent", false}));
    EXPECT_EQ(again.part("box")->reviews.at("AO4-R-1").by, "a second reader");
    EXPECT_THAT(again.part("box")->independent_reviews, IsEmpty()) << "a new independent review replaces both";
}

TEST(Review, ExpiredReviewWithNewTestHashesCoversOnlyTheText) {
    const WorkByItem then{{"AO4-R-1", {"11111111", "22222222"}}};
    const Register content = read("a", "b", after(read("a", "b", ""), by_reader, then));
    EXPECT_EQ(independent_of(content, then).covers, IndependentReview::Covers::whole);
    const WorkByItem now{{"AO4-R-1", {"11111111", "33333333"}}};
    const IndependentReview expired = independent_of(content, now);
    EXPECT_EQ(expired.covers, IndependentReview::Covers::nothing);
    EXPECT_EQ(expired.change, "its tests have changed since its review of 2026-01-02");
    const Register marked = read("a", "b", write_marked_reviews(content, *content.part("box"), "2026-03-04", now));
    EXPECT_EQ(independent_of(marked, now).covers, IndependentReview::Covers::text);
    EXPECT_EQ(counts_of(marked, ReviewedKind::item, now).independent_text, 1U);
}

TEST(Review, TwoReviewsOfOneItemInTheSameRoleAreAFault) {
    const auto block = [](const char* role) {
        return fmt::format(
            "[[review]]\ndate = \"2026-01-02\"\nby = \"x\"\nrole = \"{}\"\n[review.items]\nAO4-R-1 = \"00000000\"\n",
            role);
    };
    const auto faults = [&](const std::string& reviews) {
        SpecFiles files = with(items_file, items("a", "b"));
        files[reviews_file] = reviews;
        return all_faults(load_register(files));
    };
    const char* const twice = "AO4-R-1 is reviewed twice";
    EXPECT_THAT(faults(block("author") + block("independent")), Not(HasSubstr(twice)));
    EXPECT_THAT(faults(block("independent") + block("author")), Not(HasSubstr(twice)));
    EXPECT_THAT(faults(block("author") + block("author")), HasSubstr(twice));
    EXPECT_THAT(faults(block("independent") + block("independent")), HasSubstr(twice));
    EXPECT_THAT(faults(block("independent") + block("author") + block("independent")), HasSubstr(twice));
}

TEST(Review, UnknownReviewRoleIsRefused) {
    SpecFiles files = with(items_file, items("a", "b"));
    files[reviews_file] =
        "[[review]]\ndate = \"2026-01-02\"\nby = \"x\"\nrole = \"friend\"\n[review.items]\nAO4-R-1 = \"00000000\"\n";
    EXPECT_THAT(all_faults(load_register(files)),
                HasSubstr("role `friend` is unknown; write `author` (of the change) or `independent`"));
}

TEST(Review, ReviewOfASectionAsNormativeOrInformativeEndsWhenThatChanges) {
    const Register first = read("a", "b", "");
    const std::string reviews = reviewed(first, {"M1:1", "M1:2.1", "M1:Table 3"}, "2026-01-02", "x");
    EXPECT_THAT(waiting(read("a", "b", reviews)), ElementsAre("AO4-R-1", "AO4-R-2"));
    const Register reworded = with_manual("reason = \"a drawing\"", "reason = \"a photograph\"", reviews);
    EXPECT_THAT(waiting(reworded), ElementsAre("AO4-R-1", "AO4-R-2", "M1:2.1"));
    EXPECT_EQ((ReviewState{reworded, no_work}.suspicion("M1:2.1", {})), "changed since its review of 2026-01-02");
    EXPECT_EQ((ReviewState{reworded, no_work}.suspicion("M1:1", {})), "");
    const Register demanded =
        with_manual("disposition = \"informative\"\nreason = \"a drawing\"", "disposition = \"normative\"", reviews);
    EXPECT_THAT(waiting(demanded), ElementsAre("AO4-R-1", "AO4-R-2", "M1:2.1"));
}

TEST(Review, ReviewsOfSectionsAsNormativeOrInformativeAreCountedApartFromItems) {
    const Register first = read("a", "b", "");
    const std::string one =
        write_reviews(first, *first.part("box"), {"M1:1", "AO4-R-1"}, {"2026-01-02", "x", "independent"}, {});
    const Register content = read("a", "b", one);
    EXPECT_EQ(counts_of(content, ReviewedKind::disposition).independent, 1U);
    EXPECT_EQ(counts_of(content, ReviewedKind::item).independent, 1U);
    EXPECT_EQ(reader_words(content.part("box")->reviews.at("M1:1")), "2026-01-02 by x, not the author of the change");
}

}  // namespace canproof::host::test
