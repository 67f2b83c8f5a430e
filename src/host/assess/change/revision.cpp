// SPDX-License-Identifier: Apache-2.0
#include "host/assess/change/revision.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/child_process.hpp"
#include "host/base/input_error.hpp"
#include "host/base/lines.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::host {

namespace {

std::string git(const std::filesystem::path& root, std::vector<std::string> words, const std::string& revision) {
    words.insert(words.begin(), {"git", "-C", root.string()});
    const auto text = output_of(words);
    if (!text) {
        throw InputError{fmt::format(
            "git finds no revision `{}` in {}; install git if it is missing, and name a commit, branch or tag",
            revision, std::filesystem::absolute(root).string())};
    }
    return *text;
}

}  // namespace

SpecFiles spec_files_at(const std::filesystem::path& root, const std::string& revision) {
    // First converts the revision into a commit id, so that git cannot take a revision such as `--all` for an option.
    const std::string commit =
        split_lines(
            git(root, {"rev-parse", "--verify", "--quiet", "--end-of-options", revision + "^{commit}"}, revision))
            .at(0);
    SpecFiles files;
    for (const auto& path : split_lines(git(root, {"ls-tree", "-r", "--name-only", commit, "spec/"}, revision))) {
        if (std::filesystem::path{path}.extension() == ".toml") {
            files[path] = git(root, {"show", commit + ":./" + path}, revision);
        }
    }
    return files;
}

std::vector<std::string> files_changed_since(const std::filesystem::path& root, const std::string& revision,
                                             const std::vector<std::string>& folders) {
    std::vector<std::string> words{"diff", "--name-only", "--relative", "--end-of-options", revision, "--"};
    words.insert(words.end(), folders.begin(), folders.end());
    auto files = split_lines(git(root, words, revision));
    std::vector<std::string> others{"ls-files", "--others", "--exclude-standard", "--"};
    others.insert(others.end(), folders.begin(), folders.end());
    for (const auto& file : split_lines(git(root, others, revision))) {
        files.push_back(file);
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace canproof::host
