// SPDX-License-Identifier: Apache-2.0
// Runs a limited number of programs in parallel, each with its output in a file.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace canproof::host {

/// The way in which a program ended.
struct TaskEnd {
    int status{0};          ///< exit status, or 128 plus the number of the signal
    bool timed_out{false};  ///< whether the program reached its time limit and was ended
    bool interrupted{false};
    double seconds{0.0};
};

struct Task {
    std::vector<std::string> command;
    std::map<std::string, std::string> environment{};  ///< variables in addition to the environment of this program
    std::filesystem::path log{};                       ///< file for stdout and stderr
    double limit_seconds{0.0};                         ///< time limit; 0: none
    std::function<void()> began{};
    std::function<void(const std::string&)> line{};  ///< called for each line of the output
    std::function<void(const TaskEnd&)> ended{};
};

/// A function that the runner calls repeatedly; when it returns true, all programs are ended.
using Interrupted = std::function<bool()>;

/// Starts all tasks in their order and runs up to `width` in parallel. Calls `tick` several times a second. After an
/// interrupt, each running program gets SIGINT and, some seconds later, SIGKILL; no other task starts. Returns false
/// after an interrupt. Throws InputError when a program cannot be started.
bool run_tasks(std::vector<Task> tasks, unsigned width, const Interrupted& interrupted,
               const std::function<void()>& tick);

}  // namespace canproof::host
