// SPDX-License-Identifier: Apache-2.0
// A temporary folder for one test, which is removed at the end of the test.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

namespace canproof::test {

class ScratchFolder {
  public:
    ScratchFolder() {
        std::string pattern = testing::TempDir() + "canproof-XXXXXX";
        path_ = mkdtemp(pattern.data());
    }
    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    /// Returns the names of the files and folders in this folder.
    std::set<std::string> names() const {
        std::set<std::string> all;
        for (const auto& entry : std::filesystem::directory_iterator{path_}) {
            all.insert(entry.path().filename().string());
        }
        return all;
    }

    static std::string content(const std::filesystem::path& file) {
        std::ifstream in{file, std::ios::binary};
        return {std::istreambuf_iterator<char>{in}, {}};
    }
    static void fill(const std::filesystem::path& file, const std::string& text) {
        std::ofstream{file, std::ios::binary} << text;
    }

  private:
    std::filesystem::path path_;
};

}  // namespace canproof::test
