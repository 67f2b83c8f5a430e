// SPDX-License-Identifier: Apache-2.0
#include "host/base/files.hpp"

#include <fmt/format.h>

#include <system_error>

#include "host/base/input_error.hpp"
#include "host/base/replace_file.hpp"

namespace canproof::host {

std::ifstream open_input(const std::string& path) {
    if (std::filesystem::is_directory(path)) {
        throw InputError{fmt::format("{} is a folder; name a file", path)};
    }
    std::ifstream in{path, std::ios::binary};
    if (!in) {
        throw InputError{fmt::format("cannot read {}; name an existing file that you may read", path)};
    }
    return in;
}

void write_file(const std::filesystem::path& path, const std::string& bytes) {
    try {
        if (const auto folder = path.parent_path(); !folder.empty()) {
            std::filesystem::create_directories(folder);
        }
        replace_file(path, bytes);
    } catch (const std::system_error& error) {
        throw InputError{fmt::format("cannot write {}: {}", path.string(), error.code().message())};
    }
}

}  // namespace canproof::host
