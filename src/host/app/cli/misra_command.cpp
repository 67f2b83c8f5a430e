// SPDX-License-Identifier: Apache-2.0
// The `misra` command: runs the checkers of misra/ on a built firmware.
#include "host/app/cli/misra_command.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "host/base/input_error.hpp"

extern char** environ;

namespace canproof::host {

namespace {

/// Runs a program until it ends. The program inherits standard output. Returns the exit status of the program; 2 when a
/// signal ended it.
int run_program(const std::vector<std::string>& words) {
    std::vector<std::string> copies{words};
    std::vector<char*> arguments;
    for (auto& word : copies) {
        arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    pid_t child = 0;
    if (const int error = posix_spawn(&child, arguments[0], nullptr, nullptr, arguments.data(), environ); error != 0) {
        throw InputError{
            fmt::format("cannot start {}: {}; check that you may execute this file and that bash is installed",
                        words.front(), std::strerror(error))};
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) {
            throw InputError{
                fmt::format("cannot wait for the end of {}: {}; start this program with SIGCHLD not ignored",
                            words.front(), std::strerror(errno))};
        }
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 2;
}

/// Returns whether the folder is a build of canproof, or of another project, which builds canproof in its folder
/// `package`.
bool holds_firmware(const std::filesystem::path& build) {
    const auto library = std::filesystem::path{"src"} / "firmware" / "libcanproof_firmware_base.a";
    return std::filesystem::exists(build / library) || std::filesystem::exists(build / "package" / library);
}

std::filesystem::path build_folder(const MisraOptions& options) {
    if (!options.build.empty()) {
        return options.build;
    }
    const auto builds = std::filesystem::path{options.root} / "build";
    const auto candidates = {builds / "release", builds / "debug"};
    const auto found = std::find_if(candidates.begin(), candidates.end(), holds_firmware);
    return found == candidates.end() ? builds / "release" : *found;
}

/// Returns the source folder of canproof, which CMake's configure step wrote to home.txt in the build folder.
std::filesystem::path home_of(const std::filesystem::path& build) {
    const auto file = build / "home.txt";
    std::ifstream in{file};
    std::string home;
    if (!std::getline(in, home) || home.empty()) {
        throw InputError{
            fmt::format("{} does not name the folder of canproof; build the project first, or name the folder of its "
                        "build with --build",
                        file.string())};
    }
    return home;
}

}  // namespace

int check_misra(const MisraOptions& options) {
    const auto build = build_folder(options);
    const auto script = home_of(build) / "misra" / "run";
    if (!std::filesystem::exists(script)) {
        throw InputError{fmt::format("there is no {}; install all files of canproof, then build the project again",
                                     script.string())};
    }
    const std::string root = std::filesystem::absolute(options.root).string();
    if (!options.review_file.empty()) {
        return run_program({script.string(), "--root", root, "review", build.string(), options.review_file,
                            options.review_rule, "--by", options.reviewer, "--judgement", options.judgement});
    }
    std::vector<std::string> words{script.string(), "--root", root, build.string(),
                                   options.out.empty() ? (build / "misra").string() : options.out};
    if (options.json) {
        words.insert(words.begin() + 3, "--json");
    }
    return run_program(words);
}

}  // namespace canproof::host
