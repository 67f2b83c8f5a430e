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
        throw InputError{fmt::format("cannot read {}; name a file that exists and can be read", path)};
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
        throw InputError{fmt::format("cannot write {}: {}; correct this, or write to another place", path.string(),
                                     error.code().message())};
    }
}

std::filesystem::directory_iterator open_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::directory_iterator entries{folder, error};
    if (error) {
        throw InputError{fmt::format("cannot read the folder {}: {}; name a folder that exists and can be read",
                                     folder.string(), error.message())};
    }
    return entries;
}

void make_folder(const std::filesystem::path& folder) {
    check_folder_place(folder);
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
        throw InputError{
            fmt::format("cannot make the folder {}: {}; name another folder", folder.string(), error.message())};
    }
}

void check_folder_place(const std::filesystem::path& folder) {
    for (std::filesystem::path place = folder; !place.empty(); place = place.parent_path()) {
        std::error_code none;
        const auto status = std::filesystem::status(place, none);
        if (std::filesystem::exists(status) && !std::filesystem::is_directory(status)) {
            throw InputError{fmt::format("{} is no folder; name a folder, or remove this file", place.string())};
        }
        if (std::filesystem::exists(status) || place == place.parent_path()) {
            return;
        }
    }
}

}  // namespace canproof::host
