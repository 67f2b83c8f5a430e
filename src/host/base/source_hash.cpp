// SPDX-License-Identifier: Apache-2.0
#include "host/base/source_hash.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "host/base/read_file.hpp"
#include "host/base/sha256.hpp"

namespace canproof::host {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 5> folders{"fuzz", "properties", "spec", "src", "tests"};
constexpr std::array<std::string_view, 5> extensions{".cmake", ".cpp", ".hpp", ".py", ".toml"};

bool is_source(const fs::path& file) {
    const std::string extension = file.extension().string();
    const bool has_extension = std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
    return file.filename() != "reviews.toml" && (has_extension || file.filename() == "CMakeLists.txt");
}

}  // namespace

std::string source_hash(const fs::path& root) {
    std::vector<std::string> names;
    for (const std::string_view folder : folders) {
        if (!fs::is_directory(root / folder)) {
            continue;
        }
        for (const auto& one : fs::recursive_directory_iterator{root / folder}) {
            if (one.is_regular_file() && is_source(one.path())) {
                names.push_back(one.path().lexically_relative(root).generic_string());
            }
        }
    }
    std::sort(names.begin(), names.end());
    std::string all;
    for (const std::string& name : names) {
        all += name + '\n' + sha256(read_file(root / name)) + '\n';
    }
    return sha256(all);
}

}  // namespace canproof::host
