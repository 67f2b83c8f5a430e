// SPDX-License-Identifier: Apache-2.0
// Tests the file with the stored memory of a device: it is complete and locked, and every failure is reported.
#include "host/sim/devices/stored_memory_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "host/base/input_error.hpp"
#include "tests/support/scratch_folder.hpp"

namespace canproof::host::test {

namespace {

using canproof::test::ScratchFolder;
using testing::HasSubstr;

class StoredMemoryFile : public testing::Test {
  protected:
    void keep(Memory& memory, const std::string& name = "box.bin") {
        keep_in_file(memory, folder / name, [this](const std::string& text) { told = text; });
    }
    /// Returns the message with which the file is refused.
    std::string refusal(const std::string& name = "box.bin") {
        Memory memory{4};
        try {
            keep(memory, name);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }
    std::string content(const std::string& name = "box.bin") const { return ScratchFolder::content(folder / name); }
    static bool store(Memory& memory, const std::string& bytes) {
        return memory.write(0, ByteView{reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}) &&
               memory.commit();
    }

    ScratchFolder folder;
    std::string told;
};

}  // namespace

TEST_F(StoredMemoryFile, FileIsCreatedWithThePresentContentOfTheMemory) {
    Memory memory{4};
    keep(memory);
    EXPECT_EQ(content(), "\xFF\xFF\xFF\xFF");
    EXPECT_EQ(folder.names(), std::set<std::string>{"box.bin"});
}

TEST_F(StoredMemoryFile, CommittedMemoryIsWrittenAndReadBack) {
    {
        Memory memory{4};
        keep(memory);
        EXPECT_TRUE(store(memory, "abcd"));
        EXPECT_EQ(content(), "abcd");
        EXPECT_TRUE(memory.write(0, ByteView{memory.bytes().data() + 1, 1}));
        EXPECT_EQ(content(), "abcd");
    }
    Memory next{4};
    keep(next);
    EXPECT_EQ(next.bytes(), (std::vector<std::uint8_t>{'a', 'b', 'c', 'd'}));
}

TEST_F(StoredMemoryFile, SecondProcessIsRefusedAndGetsTheNameOfTheFileAndTheFirstProcess) {
    Memory memory{4};
    keep(memory);
    std::filesystem::create_symlink("box.bin", folder / "link.bin");
    const std::string process = "process " + std::to_string(getpid());
    for (const char* name : {"box.bin", "link.bin"}) {
        EXPECT_THAT(refusal(name), HasSubstr((folder / name).string() + " is in use by " + process));
    }
    EXPECT_TRUE(store(memory, "abcd"));  // the commit replaces the file by a new one, which is locked too
    EXPECT_THAT(refusal(), HasSubstr(process));
    EXPECT_EQ(content(), "abcd");
}

TEST_F(StoredMemoryFile, FileIsReleasedWhenTheMemoryIsDestroyed) {
    {
        Memory memory{4};
        keep(memory);
        store(memory, "abcd");
    }
    EXPECT_EQ(refusal(), "");
}

TEST_F(StoredMemoryFile, FileOfAnotherLengthIsRefusedAndUnchanged) {
    for (const char* text : {"", "abc", "abcde"}) {
        ScratchFolder::fill(folder / "box.bin", text);
        EXPECT_THAT(refusal(), HasSubstr("box.bin has " + std::to_string(std::string{text}.size()) + " bytes"));
        EXPECT_EQ(content(), text);
    }
}

TEST_F(StoredMemoryFile, FolderFifoOrDeviceIsRefusedAndUnchanged) {
    std::filesystem::create_directory(folder / "box.bin");
    EXPECT_THAT(refusal(), HasSubstr("it is a folder"));
    ASSERT_EQ(mkfifo((folder / "fifo").c_str(), 0600), 0);
    EXPECT_THAT(refusal("fifo"), HasSubstr("it is no regular file"));
    std::filesystem::create_symlink("/dev/null", folder / "device");
    EXPECT_THAT(refusal("device"), HasSubstr("it is no regular file"));
    EXPECT_TRUE(std::filesystem::is_directory(folder / "box.bin"));
    EXPECT_TRUE(std::filesystem::is_fifo(folder / "fifo"));
}

TEST_F(StoredMemoryFile, DanglingOrCircularLinkIsRefused) {
    std::filesystem::create_symlink("nowhere", folder / "box.bin");
    EXPECT_THAT(refusal(), HasSubstr("it is a link to a missing file"));
    std::filesystem::create_symlink("loop", folder / "loop");
    EXPECT_THAT(refusal("loop"), HasSubstr("cannot read"));
    EXPECT_EQ(folder.names(), (std::set<std::string>{"box.bin", "loop"}));
}

TEST_F(StoredMemoryFile, FileInAMissingFolderIsRefused) {
    EXPECT_THAT(refusal("none/box.bin"), HasSubstr("cannot write"));
    ScratchFolder::fill(folder / "file", "");
    EXPECT_THAT(refusal("file/box.bin"), HasSubstr("Not a directory"));
}

TEST_F(StoredMemoryFile, CommitRefusedByTheDiskIsReportedAndUndone) {
    Memory memory{4};
    keep(memory);
    EXPECT_TRUE(store(memory, "abcd"));
    std::filesystem::remove(folder / "box.bin");
    std::filesystem::create_directory(folder / "box.bin");
    ScratchFolder::fill(folder / "box.bin/x", "");  // a file cannot replace a folder that is not empty
    EXPECT_FALSE(store(memory, "efgh"));
    EXPECT_THAT(told, HasSubstr("box.bin"));
    EXPECT_EQ(memory.bytes(), (std::vector<std::uint8_t>{'a', 'b', 'c', 'd'}));
    EXPECT_EQ(folder.names(), std::set<std::string>{"box.bin"});
}

TEST_F(StoredMemoryFile, CommitFailsWithoutAnExceptionWhenReportingTheFailureThrows) {
    Memory memory{4};
    keep_in_file(memory, folder / "box.bin",
                 [](const std::string&) { throw std::runtime_error{"standard error is full"}; });
    std::filesystem::remove(folder / "box.bin");
    std::filesystem::create_directory(folder / "box.bin");
    EXPECT_FALSE(store(memory, "efgh"));
}

TEST_F(StoredMemoryFile, LeftoversOfAKilledProgramAreRemoved) {
    ScratchFolder::fill(folder / "box.bin", "abcd");
    ScratchFolder::fill(folder / ".box.bin.4711-0.new", "ab");
    Memory memory{4};
    keep(memory);
    EXPECT_EQ(folder.names(), std::set<std::string>{"box.bin"});
}

}  // namespace canproof::host::test
