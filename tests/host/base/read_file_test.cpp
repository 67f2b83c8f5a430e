// SPDX-License-Identifier: Apache-2.0
// Whole files are read to their end in bounded memory; folders, missing files and pipes without a writer are refused.
#include "host/base/read_file.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "host/base/input_error.hpp"

namespace canproof::host::test {

namespace {

using testing::HasSubstr;

class WholeFile : public testing::Test {
  protected:
    WholeFile() {
        std::string name = (std::filesystem::temp_directory_path() / "whole-file-XXXXXX").string();
        folder_ = ::mkdtemp(name.data());
    }
    ~WholeFile() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path file(const std::string& bytes) const {
        std::ofstream{folder_ / "file", std::ios::binary} << bytes;
        return folder_ / "file";
    }
    static std::string refusal(const std::filesystem::path& path, std::size_t most) {
        try {
            read_file(path, most);
        } catch (const InputError& error) {
            return error.what();
        }
        return "read";
    }

    std::filesystem::path folder_;
};

}  // namespace

TEST_F(WholeFile, FileIsReadUnchanged) {
    const std::string bytes("a\0\r\n\xFF", 5);
    EXPECT_EQ(read_file(file(bytes), 5), bytes);
    EXPECT_EQ(read_file(file(""), 5), "");
    const std::string large(1000000, 'x');
    EXPECT_EQ(read_file(file(large), large.size()), large);
}

TEST_F(WholeFile, FileLongerThanItsLimitIsRefusedWithItsSize) {
    EXPECT_THAT(refusal(file("123456"), 5), HasSubstr("file: it has 6 bytes, more than 5; name a shorter file"));
}

TEST_F(WholeFile, EndlessDeviceFileIsRefusedAtItsLimit) {
    EXPECT_EQ(refusal("/dev/zero", 100000),
              "cannot read /dev/zero: it has more than 100000 bytes; name a shorter file");
    EXPECT_EQ(read_file("/dev/null", 5), "");
}

TEST_F(WholeFile, FolderAndMissingFileAreRefused) {
    EXPECT_THAT(refusal(folder_, 5), HasSubstr("it is a folder; name a file"));
    EXPECT_THAT(refusal(folder_ / "none", 5),
                HasSubstr("No such file or directory; name a file that exists and can be read"));
}

TEST_F(WholeFile, PipeWithoutWriterIsRefusedAtOnce) {
    ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    EXPECT_THAT(refusal(folder_ / "pipe", 5), HasSubstr("it is a pipe without a writer; name a file"));
}

TEST_F(WholeFile, PipeWithAWriterIsReadToItsEnd) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    ASSERT_EQ(::write(ends[1], "hello", 5), 5);
    const std::string path = "/dev/fd/" + std::to_string(ends[0]);
    EXPECT_THAT(refusal(path, 4), HasSubstr("it has more than 4 bytes"));
    ASSERT_EQ(::write(ends[1], "again", 5), 5);
    ::close(ends[1]);
    EXPECT_EQ(read_file(path, 100), "again");
    ::close(ends[0]);
}

}  // namespace canproof::host::test
