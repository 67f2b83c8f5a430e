// SPDX-License-Identifier: Apache-2.0
// Tests that a file is replaced as a whole or stays unchanged.
#include "host/base/replace_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <system_error>

#include "tests/support/scratch_folder.hpp"

namespace canproof::host::test {

using canproof::test::ScratchFolder;
using Names = std::set<std::string>;

TEST(ReplaceFile, NewAndExistingFilesGetTheWholeContent) {
    const ScratchFolder folder;
    replace_file(folder / "a", "long content");
    EXPECT_EQ(ScratchFolder::content(folder / "a"), "long content");
    replace_file(folder / "a", "short");
    EXPECT_EQ(ScratchFolder::content(folder / "a"), "short");
    EXPECT_EQ(folder.names(), Names{"a"});
}

TEST(ReplaceFile, OldContentStaysWhenTheNewContentIsAbandoned) {
    const ScratchFolder folder;
    ScratchFolder::fill(folder / "a", "old");
    {
        FileBeside fresh{folder / "a"};
        fresh.write("new");
        EXPECT_EQ(ScratchFolder::content(folder / "a"), "old");
    }
    EXPECT_EQ(ScratchFolder::content(folder / "a"), "old");
    EXPECT_EQ(folder.names(), Names{"a"});
}

TEST(ReplaceFile, LinkIsFollowedAndPermissionsAreKept) {
    const ScratchFolder folder;
    ScratchFolder::fill(folder / "a", "old");
    chmod((folder / "a").c_str(), 0640);
    std::filesystem::create_symlink("a", folder / "link");
    replace_file(folder / "link", "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
    EXPECT_EQ(ScratchFolder::content(folder / "a"), "new");
    struct stat found {};
    ASSERT_EQ(stat((folder / "a").c_str(), &found), 0);
    EXPECT_EQ(found.st_mode & 0777U, 0640U);
}

TEST(ReplaceFile, UnwritableTargetIsRefused) {
    const ScratchFolder folder;
    EXPECT_THROW(replace_file(folder / "none" / "a", "x"), std::system_error);
    EXPECT_THROW(replace_file(folder / "", "x"), std::system_error);  // the target is a folder
    EXPECT_THROW(replace_file("/dev/full", "x"), std::system_error);
    std::filesystem::create_symlink("nowhere", folder / "link");
    EXPECT_THROW(replace_file(folder / "link", "x"), std::system_error);
    EXPECT_EQ(folder.names(), Names{"link"});
}

TEST(ReplaceFile, DeviceFileIsWrittenDirectly) {
    replace_file("/dev/null", "x");
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(FileBeside, TargetFileIsCreatedOnlyIfItIsAbsent_AndIsLocked) {
    const ScratchFolder folder;
    FileBeside first{folder / "a"};
    FileBeside second{folder / "a"};
    first.write("first");
    second.write("second");
    EXPECT_TRUE(first.create());
    EXPECT_FALSE(second.create());
    EXPECT_EQ(ScratchFolder::content(folder / "a"), "first");
    const Descriptor other{open((folder / "a").c_str(), O_RDONLY)};
    EXPECT_NE(flock(other.number(), LOCK_EX | LOCK_NB), 0);
    first.take();
    EXPECT_EQ(flock(other.number(), LOCK_EX | LOCK_NB), 0);
}

TEST(FileBeside, OnlyLeftoverTemporaryFilesOfTheTargetAreRemoved) {
    const ScratchFolder folder;
    for (const char* name : {"a", ".a.12-0.new", ".a.new", ".a.mine.new", ".b.12-0.new", ".a.12-0.old"}) {
        ScratchFolder::fill(folder / name, "x");
    }
    remove_leftovers(folder / "a");
    EXPECT_EQ(folder.names(), (Names{"a", ".a.new", ".a.mine.new", ".b.12-0.new", ".a.12-0.old"}));
}

}  // namespace canproof::host::test
