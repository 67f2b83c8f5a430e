// Records of reviews: written, read again, and renewed for what was named alone.
#include "host/assess/trace/review.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/register/load.hpp"
#include "host/register/spec_files.hpp"
#include "tests/host/register/small_register.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

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
    return write_reviews(*content.part("box"), ids, date, by);
}

}  // namespace

TEST(Review, EverythingIsUnreviewedAtFirst) {
    EXPECT_THAT(unreviewed(*read("a", "b", "").part("box")), ElementsAre("AO4-R-1", "AO4-R-2"));
}

TEST(Review, IsReadBackAsItWasWritten) {
    const std::string text = reviewed(read("a", "b", ""), {"AO4-R-1", "AO4-R-2"}, "2026-01-02", "A \"B\"");
    const Register content = read("a", "b", text);
    EXPECT_THAT(unreviewed(*content.part("box")), IsEmpty());
    EXPECT_EQ(content.part("box")->reviews.at("AO4-R-1").by, "A \"B\"");
    EXPECT_EQ(ReviewState{content}.suspicion("AO4-R-1", {}), "");
}

TEST(Review, RenewsWhatIsNamedAndKeepsTheRest) {
    const std::string first = reviewed(read("a", "b", ""), {"AO4-R-1", "AO4-R-2"}, "2026-01-02", "one");
    const Register edited = read("a, but other", "b, but other", first);
    EXPECT_THAT(unreviewed(*edited.part("box")), ElementsAre("AO4-R-1", "AO4-R-2"));
    const Register again = read("a, but other", "b, but other", reviewed(edited, {"AO4-R-2"}, "2026-03-04", "two"));
    EXPECT_THAT(unreviewed(*again.part("box")), ElementsAre("AO4-R-1"));
    EXPECT_EQ(again.part("box")->reviews.at("AO4-R-1").date, "2026-01-02");
    EXPECT_EQ(again.part("box")->reviews.at("AO4-R-2").date, "2026-03-04");
    EXPECT_EQ(ReviewState{again}.suspicion("AO4-R-1", {}), "changed since its review of 2026-01-02");
}

TEST(Review, OfTheSameItemTwiceIsAFault) {
    const std::string block = "[[review]]\ndate = \"2026-01-02\"\nby = \"x\"\n[review.items]\nAO4-R-1 = \"0\"\n";
    SpecFiles files = with(items_file, items("a", "b"));
    files[reviews_file] = block + block;
    EXPECT_THAT(all_faults(load_register(files)),
                HasSubstr("spec/devices/box/reviews.toml:10: AO4-R-1 is reviewed twice; keep the later one"));
}

}  // namespace canproof::host::test
