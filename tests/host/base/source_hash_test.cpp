// SPDX-License-Identifier: Apache-2.0
// Tests the hash of a project's sources: it changes when a source changes, and not otherwise.
#include "host/base/source_hash.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "host/base/files.hpp"
#include "tests/support/scratch_folder.hpp"

namespace canproof::host::test {
namespace {

namespace fs = std::filesystem;

class SourceHash : public testing::Test {
  protected:
    SourceHash() { write("", "src/a.cpp", "int a;"); }

    void write(const std::string& tree, const std::string& name, const std::string& text) const {
        const fs::path file = folder / tree / name;
        fs::create_directories(file.parent_path());
        write_file(file, text);
    }
    std::string hash(const std::string& tree = "") const { return source_hash(folder / tree); }

    canproof::test::ScratchFolder folder;
};

TEST_F(SourceHash, HashChangesWithNameContentAndNumberOfSources) {
    const std::string first = hash();
    write("", "src/a.cpp", "int b;");
    EXPECT_NE(hash(), first);
    write("", "src/a.cpp", "int a;");
    EXPECT_EQ(hash(), first);
    write("", "src/CMakeLists.txt", "");
    EXPECT_NE(hash(), first);
    fs::rename(folder / "" / "src/CMakeLists.txt", folder / "" / "src/b.cmake");
    const std::string renamed = hash();
    fs::rename(folder / "" / "src/b.cmake", folder / "" / "src/c.cmake");
    EXPECT_NE(hash(), renamed);
}

TEST_F(SourceHash, FileInAnyFolderOfSourcesChangesTheHash) {
    std::string before = hash();
    for (const char* name : {"fuzz/x.cpp", "properties/x.cpp", "spec/x.toml", "tests/x.hpp", "tests/run/x.py"}) {
        write("", name, "x");
        EXPECT_NE(hash(), before) << name;
        before = hash();
    }
}

TEST_F(SourceHash, ReviewsPagesCorporaAndBuildsDoNotChangeTheHash) {
    const std::string before = hash();
    for (const char* name : {"spec/reviews.toml", "src/README.md", "fuzz/corpus/sdo/one", "build/src/x.cpp"}) {
        write("", name, "x");
        EXPECT_EQ(hash(), before) << name;
    }
}

TEST_F(SourceHash, EqualTreesInTwoFoldersHaveTheSameHash) {
    for (const char* tree : {"one", "two/three"}) {
        write(tree, "src/a.cpp", "int a;");
        write(tree, "spec/b.toml", "b = 1");
    }
    EXPECT_EQ(hash("one"), hash("two/three"));
}

}  // namespace
}  // namespace canproof::host::test
