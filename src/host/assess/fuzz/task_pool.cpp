// SPDX-License-Identifier: Apache-2.0
#include "host/assess/fuzz/task_pool.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <memory>
#include <thread>

#include "host/base/input_error.hpp"

namespace canproof::host {

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto look_again = std::chrono::milliseconds{20};
constexpr double grace_seconds = 5.0;

double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A program in its own process group. Ctrl-C in the terminal therefore interrupts only canproof, which then interrupts
/// the program.
class Child {
  public:
    explicit Child(Task task) : task_{std::move(task)}, start_{Clock::now()} {
        std::filesystem::create_directories(task_.log.parent_path());
        std::ofstream{task_.log};
        output_.open(task_.log);
        if (task_.began) {
            task_.began();
        }
        spawn();
    }

    bool over(bool interrupted) {
        int status = 0;
        const bool gone = waitpid(pid_, &status, WNOHANG) == pid_;
        read_lines(gone);
        if (gone) {
            end_.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
            end_.seconds = since(start_);
            kill(-pid_, SIGKILL);  // ends processes that the program has started and left running
            if (task_.ended) {
                task_.ended(end_);
            }
            return true;
        }
        end_.timed_out = end_.timed_out || (task_.limit_seconds > 0.0 && since(start_) > task_.limit_seconds);
        end_.interrupted = end_.interrupted || interrupted;
        if (end_.timed_out || end_.interrupted) {
            stop();
        }
        return false;
    }

  private:
    void spawn() {
        posix_spawn_file_actions_t files;
        posix_spawn_file_actions_init(&files);
        posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, task_.log.c_str(), O_WRONLY | O_APPEND, 0);
        posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
        posix_spawnattr_t attributes;
        posix_spawnattr_init(&attributes);
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
        posix_spawnattr_setpgroup(&attributes, 0);
        sigset_t as_usual;
        sigemptyset(&as_usual);
        sigaddset(&as_usual, SIGINT);
        posix_spawnattr_setsigdefault(&attributes, &as_usual);
        std::vector<std::string> environment = variables();
        std::vector<char*> arguments = pointers(task_.command);
        std::vector<char*> settings = pointers(environment);
        const int error = posix_spawnp(&pid_, arguments[0], &files, &attributes, arguments.data(), settings.data());
        posix_spawn_file_actions_destroy(&files);
        posix_spawnattr_destroy(&attributes);
        if (error != 0) {
            throw InputError{
                fmt::format("cannot start {}: {}; check that this program exists and that you may execute it",
                            task_.command[0], std::strerror(error))};
        }
    }

    std::vector<std::string> variables() const {
        std::vector<std::string> all;
        for (char** one = environ; *one != nullptr; ++one) {
            const std::string text{*one};
            if (task_.environment.count(text.substr(0, text.find('='))) == 0) {
                all.push_back(text);
            }
        }
        for (const auto& [name, value] : task_.environment) {
            all.push_back(name + "=" + value);
        }
        return all;
    }

    static std::vector<char*> pointers(std::vector<std::string>& texts) {
        std::vector<char*> all;
        for (auto& text : texts) {
            all.push_back(text.data());
        }
        all.push_back(nullptr);
        return all;
    }

    void read_lines(bool to_the_end) {
        output_.clear();
        for (int c = output_.get(); c != EOF; c = output_.get()) {
            if (c != '\n') {
                line_ += static_cast<char>(c);
                continue;
            }
            deliver();
        }
        if (to_the_end && !line_.empty()) {
            deliver();
        }
    }
    void deliver() {
        if (task_.line) {
            task_.line(line_);
        }
        line_.clear();
    }

    void stop() {
        if (!asked_) {
            asked_ = true;
            asked_at_ = Clock::now();
            kill(-pid_, SIGINT);
        } else if (since(asked_at_) > grace_seconds) {
            kill(-pid_, SIGKILL);
        }
    }

    Task task_;
    Clock::time_point start_;
    pid_t pid_{-1};
    std::ifstream output_;
    std::string line_;
    TaskEnd end_{};
    bool asked_{false};
    Clock::time_point asked_at_{};
};

}  // namespace

bool run_tasks(std::vector<Task> tasks, unsigned width, const Interrupted& interrupted,
               const std::function<void()>& tick) {
    std::vector<std::unique_ptr<Child>> running;
    std::size_t next = 0;
    bool stopped = false;
    while (!running.empty() || (next < tasks.size() && !stopped)) {
        stopped = stopped || interrupted();
        for (; !stopped && running.size() < width && next < tasks.size(); ++next) {
            running.push_back(std::make_unique<Child>(std::move(tasks[next])));
        }
        running.erase(std::remove_if(running.begin(), running.end(), [&](auto& child) { return child->over(stopped); }),
                      running.end());
        tick();
        if (!running.empty()) {
            std::this_thread::sleep_for(look_again);
        }
    }
    return !stopped;
}

}  // namespace canproof::host
