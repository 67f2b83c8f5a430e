// SPDX-License-Identifier: Apache-2.0
#include "host/app/cli/output_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "host/base/input_error.hpp"

namespace canproof::host {

namespace {

[[noreturn]] void refuse_to_write(const std::string& path) {
    throw InputError{fmt::format("cannot write {} ({}); name another file", path, std::strerror(errno))};
}

/// Returns whether both names refer to one regular file. A device such as /dev/null may be named several times.
bool same_file(const std::string& one, const std::string& other) {
    std::error_code none;
    return std::filesystem::is_regular_file(one, none) && std::filesystem::equivalent(one, other, none);
}

}  // namespace

void OutputFile::flush() {
    if (out_.is_open()) {
        out_.flush();
    }
}

void OutputFile::finish() {
    flush();
    if (out_.is_open() && !out_) {
        throw InputError{
            fmt::format("{} could not be written completely; free space on its disk, or name another file", path_)};
    }
}

void OutputFile::open(const std::vector<OutputFile*>& files, const std::vector<std::string>& inputs) {
    std::vector<std::string> taken = inputs;
    for (OutputFile* const file : files) {
        if (!file->is_wanted()) {
            continue;
        }
        // Opening for appending creates the file if necessary and keeps its content.
        file->out_.open(file->path_, std::ios::binary | std::ios::app);
        if (!file->out_) {
            refuse_to_write(file->path_);
        }
        if (std::any_of(taken.begin(), taken.end(), [&](const auto& one) { return same_file(file->path_, one); })) {
            throw InputError{fmt::format(
                "{} is named twice, as an output and as another file; name another file to write", file->path_)};
        }
        taken.push_back(file->path_);
    }
    for (OutputFile* const file : files) {
        if (file->is_wanted()) {
            file->out_.close();
            file->out_.open(file->path_, std::ios::binary | std::ios::trunc);
            if (!file->out_) {
                refuse_to_write(file->path_);
            }
        }
    }
}

}  // namespace canproof::host
