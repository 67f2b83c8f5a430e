// Runs programs beside each other, a few at a time, each with its output in a file.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace canproof::host {

/// How a program ended.
struct TaskEnd {
    int status{0};          ///< exit status, or 128 plus the signal's number
    bool timed_out{false};  ///< was ended because of its limit
    bool interrupted{false};
    double seconds{0.0};
};

struct Task {
    std::vector<std::string> command;
    std::map<std::string, std::string> environment{};  ///< in addition to ours
    std::filesystem::path log{};                       ///< stdout and stderr
    double limit_seconds{0.0};                         ///< 0: none
    std::function<void()> began{};
    std::function<void(const std::string&)> line{};  ///< each whole line of the output, as it comes
    std::function<void(const TaskEnd&)> ended{};
};

/// Asked again and again; true ends everything.
using Interrupted = std::function<bool()>;

/// Runs all, `width` beside each other, in their order. `tick` is called some times a second. On an interrupt each
/// running program gets SIGINT, some seconds to end, and then SIGKILL; those not begun are not begun. Returns whether
/// all ran. Throws InputError when a program cannot be started.
bool run_tasks(std::vector<Task> tasks, unsigned width, const Interrupted& interrupted,
               const std::function<void()>& tick);

}  // namespace canproof::host
