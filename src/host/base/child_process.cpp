// SPDX-License-Identifier: Apache-2.0
#include "host/base/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "host/base/input_error.hpp"

extern char** environ;

namespace canproof::host {

namespace {

/// Returns the argument list for posix_spawn: a pointer to each word, then a null pointer.
std::vector<char*> pointers(const std::vector<std::string>& words) {
    std::vector<char*> all;
    for (const auto& word : words) {
        all.push_back(const_cast<char*>(word.c_str()));
    }
    all.push_back(nullptr);
    return all;
}

/// Returns the environment of this process, in which the settings of `more` (NAME=VALUE) replace those of the same
/// name.
std::vector<std::string> environment_with(const std::vector<std::string>& more) {
    std::vector<std::string> all = more;
    for (char** one = environ; *one != nullptr; ++one) {
        const std::string setting{*one};
        const std::string name = setting.substr(0, setting.find('=')) + "=";
        if (std::none_of(more.begin(), more.end(), [&](const auto& own) { return own.rfind(name, 0) == 0; })) {
            all.push_back(setting);
        }
    }
    return all;
}

/// Waits for the end of a process; continues to wait when a signal interrupts the wait. Returns false with errno set
/// when waiting fails.
bool waits_for_end(pid_t process, int& status) noexcept {
    pid_t ended = -1;
    do {
        ended = waitpid(process, &status, 0);
    } while (ended < 0 && errno == EINTR);
    return ended >= 0;
}

}  // namespace

void refuse_to_start(const std::string& name, int error) {
    throw InputError{fmt::format("cannot run {0}: {1}; check that {0} is built or installed and may be executed", name,
                                 std::strerror(error))};
}

pid_t start_process(const std::vector<std::string>& words, const std::vector<std::string>& more_environment,
                    Streams streams) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    if (streams.in >= 0) {
        posix_spawn_file_actions_adddup2(&actions, streams.in, STDIN_FILENO);
    } else {
        posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    }
    if (streams.out >= 0) {
        posix_spawn_file_actions_adddup2(&actions, streams.out, STDOUT_FILENO);
    } else {
        posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    }
    const std::vector<std::string> environment = environment_with(more_environment);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, streams.apart ? POSIX_SPAWN_SETPGROUP : 0);
    pid_t process = -1;
    const int wrong = posix_spawnp(&process, words.front().c_str(), &actions, &attributes, pointers(words).data(),
                                   pointers(environment).data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (wrong != 0) {
        refuse_to_start(words.front(), wrong);
    }
    return process;
}

int wait_for_process(pid_t process) {
    int status = 0;
    if (!waits_for_end(process, status)) {
        throw InputError{fmt::format("cannot wait for process {}: {}; start this program with SIGCHLD not ignored",
                                     process, std::strerror(errno))};
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void reap_process(pid_t process) noexcept {
    int status = 0;
    static_cast<void>(waits_for_end(process, status));
}

Pipe make_pipe() {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
        throw InputError{"cannot open a pipe; if too many files are open, close other programs"};
    }
    return {Descriptor{ends[0]}, Descriptor{ends[1]}};
}

PipeStream open_stream(Descriptor end, const char* mode) {
    PipeStream stream{fdopen(end.number(), mode)};
    if (!stream) {
        throw InputError{fmt::format("cannot use a pipe: {}; close other programs", std::strerror(errno))};
    }
    end.release();  // the stream closes the descriptor
    return stream;
}

bool read_line(std::FILE* from, std::string& line) {
    line.clear();
    for (int c = std::fgetc(from); c != EOF; c = std::fgetc(from)) {
        if (c == '\n') {
            return true;
        }
        line += static_cast<char>(c);
    }
    return !line.empty();
}

std::optional<std::string> output_of(const std::vector<std::string>& words) {
    Pipe pipe = make_pipe();
    const pid_t process = start_process(words, {}, {-1, pipe.writes.number()});
    pipe.writes = {};
    std::string text;
    std::array<char, 4096> piece{};
    for (ssize_t count = 0; (count = read(pipe.reads.number(), piece.data(), piece.size())) > 0;) {
        text.append(piece.data(), static_cast<std::size_t>(count));
    }
    pipe.reads = {};
    return wait_for_process(process) == 0 ? std::optional{text} : std::nullopt;
}

}  // namespace canproof::host
