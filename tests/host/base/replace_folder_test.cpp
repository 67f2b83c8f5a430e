// SPDX-License-Identifier: Apache-2.0
// Tests that a folder is replaced as a whole or stays unchanged.
#include "host/base/replace_folder.hpp"

#include <gtest/gtest.h>

#include <system_error>

#include "host/base/input_error.hpp"
#include "tests/support/scratch_folder.hpp"

namespace canproof::host::test {

using canproof::test::ScratchFolder;
using Names = std::set<std::string>;

TEST(ReplaceFolder, ReplacedFolderHasTheNewFilesOnly) {
    const ScratchFolder folder;
    replace_folder(folder / "pack", {{"a", "1"}, {"b/c", "2"}});
    EXPECT_EQ(ScratchFolder::content(folder / "pack/b/c"), "2");
    replace_folder(folder / "pack", {{"a", "3"}});
    EXPECT_EQ(ScratchFolder::content(folder / "pack/a"), "3");
    EXPECT_FALSE(std::filesystem::exists(folder / "pack/b"));
    EXPECT_EQ(folder.names(), Names{"pack"});
}

TEST(ReplaceFolder, FolderMayHaveARelativePath) {
    const ScratchFolder folder;
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder / ".");
    EXPECT_NO_THROW(replace_folder("pack", {{"a", "1"}}));
    std::filesystem::current_path(before);
    EXPECT_EQ(ScratchFolder::content(folder / "pack/a"), "1");
    EXPECT_EQ(folder.names(), Names{"pack"});
}

TEST(ReplaceFolder, OldFolderStaysWhenANewFileCannotBeWritten) {
    const ScratchFolder folder;
    replace_folder(folder / "pack", {{"a", "1"}});
    EXPECT_THROW(replace_folder(folder / "pack", {{"a", "2"}, {"a/b", "3"}}), std::system_error);
    EXPECT_EQ(ScratchFolder::content(folder / "pack/a"), "1");
    EXPECT_EQ(folder.names(), Names{"pack"});
}

TEST(ReplaceFolder, FileWhereTheFolderOrItsParentShouldBeIsNotReplaced) {
    const ScratchFolder folder;
    ScratchFolder::fill(folder / "empty", "");
    for (const char* place : {"empty", "empty/", "empty/pack", "empty/a/pack"}) {
        EXPECT_THROW(replace_folder(folder / place, {{"a", "1"}}), InputError) << place;
    }
    EXPECT_EQ(ScratchFolder::content(folder / "empty"), "");
    EXPECT_EQ(folder.names(), Names{"empty"});
}

// On a file system that cannot exchange two folders in one step, a program can be killed between its two moves.
TEST(ReplaceFolder, FolderThatAKilledProgramMovedAwayIsRestored) {
    const ScratchFolder folder;
    std::filesystem::create_directories(folder / ".pack.new.old");
    ScratchFolder::fill(folder / ".pack.new.old/a", "old");
    EXPECT_THROW(replace_folder(folder / "pack", {{"a", "2"}, {"a/b", "3"}}), std::system_error);
    EXPECT_EQ(ScratchFolder::content(folder / "pack/a"), "old");
    EXPECT_EQ(folder.names(), Names{"pack"});
    replace_folder(folder / "pack", {{"a", "2"}});
    EXPECT_EQ(ScratchFolder::content(folder / "pack/a"), "2");
}

TEST(ReplaceFolder, OldFolderOfAKilledProgramIsRemovedWhenTheNewFolderExists) {
    const ScratchFolder folder;
    replace_folder(folder / "pack", {{"a", "1"}});
    std::filesystem::create_directories(folder / ".pack.new.old");
    ScratchFolder::fill(folder / ".pack.new.old/a", "old");
    EXPECT_THROW(replace_folder(folder / "pack", {{"a", "2"}, {"a/b", "3"}}), std::system_error);
    EXPECT_EQ(ScratchFolder::content(folder / "pack/a"), "1");
    EXPECT_EQ(folder.names(), Names{"pack"});
}

TEST(ReplaceFolder, LeftoversOfAKilledProgramAreRemoved) {
    const ScratchFolder folder;
    std::filesystem::create_directories(folder / ".pack.new");
    ScratchFolder::fill(folder / ".pack.new/stale", "x");
    replace_folder(folder / "pack", {{"a", "1"}});
    EXPECT_FALSE(std::filesystem::exists(folder / "pack/stale"));
    EXPECT_EQ(folder.names(), Names{"pack"});
}

}  // namespace canproof::host::test
