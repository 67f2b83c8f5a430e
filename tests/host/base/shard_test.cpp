// SPDX-License-Identifier: Apache-2.0
// Tests shards (parts) of a list of work: how they are written, what each contains, and whether all are there.
#include "host/base/shard.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/input_error.hpp"

namespace canproof::host::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string complaint_about(const std::vector<Shard>& shards) {
    std::vector<std::string> names;
    for (std::size_t at = 0; at < shards.size(); ++at) {
        names.push_back("file" + std::to_string(at));
    }
    try {
        require_all_shards(shards, names);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Shard, ShardIsReadAndWrittenAsNumberAndCount) {
    const Shard shard = parse_shard("2/3");
    EXPECT_EQ(shard.number, 2U);
    EXPECT_EQ(shard.count, 3U);
    EXPECT_EQ(shard.text(), "2/3");
    EXPECT_EQ(parse_shard("1/1").text(), "1/1");
}

TEST(Shard, InvalidShardTextIsRefused) {
    for (const char* text : {"", "2", "/3", "2/", "0/3", "4/3", "1/0", "-1/3", "1/3 ", " 1/3", "1/3/5", "a/b",
                             "1/10001", "1/99999999999999999999"}) {
        EXPECT_THROW(parse_shard(text), InputError) << text;
    }
}

TEST(Shard, ShardOfNContainsEveryNthElement) {
    const std::vector<int> all{0, 1, 2, 3, 4, 5, 6};
    EXPECT_THAT(share_of(all, {1, 3}), ElementsAre(0, 3, 6));
    EXPECT_THAT(share_of(all, {2, 3}), ElementsAre(1, 4));
    EXPECT_THAT(share_of(all, {3, 3}), ElementsAre(2, 5));
    EXPECT_EQ(share_of(all, {1, 1}), all);
    EXPECT_THAT(share_of(all, {8, 9}), IsEmpty());
}

TEST(Shard, CalculatedShardSizeIsTheNumberOfItsElements) {
    for (std::size_t all = 0; all < 12; ++all) {
        for (std::size_t count = 1; count < 6; ++count) {
            for (std::size_t number = 1; number <= count; ++number) {
                const Shard shard{number, count};
                EXPECT_EQ(size_of_share(all, shard), share_of(std::vector<int>(all), shard).size())
                    << all << " elements, shard " << shard.text();
            }
        }
    }
}

TEST(Shard, ShardsMadeFromDifferentSourcesAreRefused) {
    EXPECT_NO_THROW(require_same_sources({"a", "a"}, {"one", "two"}));
    try {
        require_same_sources({"a", "a", "b"}, {"one", "two", "three"});
        ADD_FAILURE() << "no error";
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "one and three come from different sources; run all shards from one commit");
    }
}

TEST(Shard, MergeNeedsEachShardExactlyOnce) {
    EXPECT_EQ(complaint_about({{1, 1}}), "");
    EXPECT_EQ(complaint_about({{2, 3}, {1, 3}, {3, 3}}), "");
    EXPECT_THAT(complaint_about({}), HasSubstr("no shard"));
    EXPECT_THAT(complaint_about({{1, 3}, {3, 3}}), HasSubstr("shard 2/3 is missing"));
    EXPECT_THAT(complaint_about({{1, 2}, {2, 2}, {1, 2}}), HasSubstr("file0 and file2 are both shard 1/2"));
    EXPECT_THAT(complaint_about({{1, 2}, {2, 3}}), HasSubstr("file0 is shard 1/2 and file1 is shard 2/3"));
}

}  // namespace
}  // namespace canproof::host::test
