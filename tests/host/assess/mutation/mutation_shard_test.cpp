// SPDX-License-Identifier: Apache-2.0
// Tests mutation testing that is split over several machines: the merged shards must give the same report as one
// machine.
#include "host/assess/mutation/mutation_shard.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "host/assess/mutation/code_exhibit.hpp"
#include "host/assess/mutation/mutation_json.hpp"
#include "host/base/files.hpp"
#include "host/base/input_error.hpp"

namespace canproof::host::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Seven mutants. Failed tests of three kinds and a crash reveal five of them. Two survive: one of an item that
/// a test names in verifies<>, and one of an item that no test names.
std::vector<MutationOutcome> seven_outcomes() {
    const auto cell = [](std::size_t number, const char* change) {
        return AlteredCell{10 + number, "src/firmware/canopen/nmt.cpp", "f(), line " + std::to_string(number), change};
    };
    return {{cell(0, "a < b -> a <= b"), "Nmt.Starts", true, nullptr, "tests/conformance/nmt_test.cpp"},
            {cell(1, "a -> true"), "", true, nullptr, ""},
            {cell(2, "g() -> deleted"), "signal 11", true, nullptr, ""},
            {cell(3, "1 -> +1"), "", false, nullptr, ""},
            {cell(4, "1 -> -1"), "NmtLaw.Holds", true, nullptr, "properties/nmt_property.cpp"},
            {cell(5, "a && \"b\" -> ||"), "Nmt.Stops", true, nullptr, "tests/firmware/nmt_test.cpp"},
            {cell(6, "x = 1 -> dropped"), "Nmt.Starts", true, nullptr, "tests/conformance/nmt_test.cpp"}};
}

std::vector<AlteredCell> cells_of(const std::vector<MutationOutcome>& outcomes) {
    std::vector<AlteredCell> cells;
    for (const MutationOutcome& one : outcomes) {
        cells.push_back(one.cell);
    }
    return cells;
}

class MutationShards : public testing::Test {
  protected:
    MutationShards() {
        std::string name = (fs::temp_directory_path() / "shards-XXXXXX").string();
        folder = mkdtemp(name.data());
    }
    ~MutationShards() override { fs::remove_all(folder); }

    void leave(const Shard& shard) const {
        write_file(folder / mutation_shard_name(true, shard), write_mutation_shard(shard, "a", share_of(whole, shard)));
    }
    std::vector<MutationOutcome> merged() const { return merge_mutation_shards(folder, true, cells_of(whole)); }
    std::string complaint() const {
        try {
            merged();
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }

    fs::path folder;
    std::vector<MutationOutcome> whole = seven_outcomes();
};

TEST_F(MutationShards, MergedShardsEqualTheResultOfOneMachineByteForByte) {
    for (const std::size_t count : {1U, 2U, 3U, 7U, 9U}) {
        fs::remove_all(folder);
        for (std::size_t number = count; number >= 1; --number) {
            leave({number, count});
        }
        EXPECT_EQ(write_mutation_json(merged()), write_mutation_json(whole)) << count << " shards";
        EXPECT_EQ(code_exhibit(merged()), code_exhibit(whole)) << count << " shards";
    }
}

TEST_F(MutationShards, ShardsOfTableMutantsAreNotMergedAsShardsOfCodeMutants) {
    leave({1, 1});
    write_file(folder / mutation_shard_name(false, {1, 1}), write_mutation_shard({1, 1}, "a", {}));
    EXPECT_EQ(merged().size(), whole.size());
    EXPECT_TRUE(merge_mutation_shards(folder, false, {}).empty());
}

TEST_F(MutationShards, MissingShardIsReportedWithItsNumber) {
    EXPECT_THAT(complaint(), HasSubstr("no shard to merge"));
    leave({1, 3});
    leave({3, 3});
    EXPECT_THAT(complaint(), HasSubstr("shard 2/3 is missing"));
}

TEST_F(MutationShards, ShardWithResultsOfOtherMutantsIsRefused) {
    leave({1, 2});
    leave({2, 2});
    EXPECT_EQ(complaint(), "");
    auto other = whole;
    other[3].cell.change = "1 -> +2";
    write_file(folder / mutation_shard_name(true, {2, 2}), write_mutation_shard({2, 2}, "a", share_of(other, {2, 2})));
    EXPECT_THAT(complaint(), HasSubstr("has outcomes of other alterations; run `--shard 2/2`"));
    whole.push_back(whole.back());
    leave({2, 2});
    EXPECT_EQ(share_of(whole, {1, 2}).size(), 4U);
    EXPECT_EQ(complaint(), "") << "an eighth alteration belongs to the second shard alone";
    whole.push_back(whole.back());
    EXPECT_THAT(complaint(), HasSubstr("has outcomes of other alterations; run `--shard 1/2`"));
}

TEST_F(MutationShards, ShardMadeFromOtherSourcesIsRefused) {
    leave({1, 2});
    write_file(folder / mutation_shard_name(true, {2, 2}), write_mutation_shard({2, 2}, "b", share_of(whole, {2, 2})));
    EXPECT_THAT(complaint(), HasSubstr("come from different sources"));
}

TEST_F(MutationShards, InvalidShardFileIsReportedWithItsPath) {
    leave({1, 2});
    const fs::path file = folder / mutation_shard_name(true, {2, 2});
    for (const char* text :
         {"", "{", "[]", "{}", R"({"shard": "2/2", "sources": "a", "outcomes": [{"number": "x"}]})"}) {
        write_file(file, text);
        EXPECT_THAT(complaint(), HasSubstr(file.string() + " is no result of")) << text;
    }
    write_file(file, R"({"shard": "3/2", "sources": "a", "outcomes": []})");
    EXPECT_THAT(complaint(), HasSubstr("`3/2` is not a shard"));
}

}  // namespace
}  // namespace canproof::host::test
