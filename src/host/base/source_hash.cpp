// SPDX-License-Identifier: Apache-2.0
#include "host/base/source_hash.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "host/base/read_file.hpp"
#include "host/base/sha256.hpp"

namespace canproof::host {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 5> extensions{".cmake", ".cpp", ".hpp", ".py", ".toml"};

bool is_source(const fs::path& file) {
    const std::string extension = file.extension().string();
    const bool has_extension = std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
    return file.filename() != "reviews.toml" && (has_extension || file.filename() == "CMakeLists.txt");
}

}  // namespace

FileHashes file_hashes(const fs::path& root, const std::vector<std::string>& folders,
                       const std::function<bool(const fs::path&)>& accepts) {
    FileHashes all;
    for (const std::string& folder : folders) {
        if (!fs::is_directory(root / folder)) {
            continue;
        }
        for (const auto& one : fs::recursive_directory_iterator{root / folder}) {
            if (one.is_regular_file() && accepts(one.path())) {
                all[one.path().lexically_relative(root).generic_string()] = sha256(read_file(one.path()));
            }
        }
    }
    return all;
}

std::string source_hash(const fs::path& root) {
    std::string all;
    for (const auto& [name, hash] : file_hashes(root, {"fuzz", "properties", "spec", "src", "tests"}, is_source)) {
        all += name + '\n' + hash + '\n';
    }
    return sha256(all);
}

}  // namespace canproof::host
