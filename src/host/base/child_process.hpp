// SPDX-License-Identifier: Apache-2.0
// Starts other programs without a shell.
#pragma once

#include <sys/types.h>

#include <array>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace canproof::host {

/// Descriptors for standard input and output of a program. -1 selects /dev/null; for `out`, standard error goes there
/// as well.
struct Streams {
    int in{-1};
    int out{-1};
    bool apart{false};  ///< runs it in its own process group, so that Ctrl-C at the terminal does not reach it
};

/// Starts a program. `words` holds a path, or a name to find in PATH, and the arguments. `more_environment` holds
/// `NAME=value`, which precedes the environment of this program. Throws InputError when there is no such program.
pid_t start_process(const std::vector<std::string>& words, const std::vector<std::string>& more_environment,
                    Streams streams);
/// Waits for the end of a process, also when signals interrupt the wait. Returns its exit status; 128 plus the signal's
/// number when a signal ended it. Throws InputError when `process` is no child of this program.
int wait_for_process(pid_t process);
/// Waits in a destructor: drops the exit status, and returns at once when `process` is no child of this program.
void reap_process(pid_t process) noexcept;

/// Returns both ends of a pipe, which started programs do not inherit. Throws InputError.
std::array<int, 2> make_pipe();
/// Reads the next line without its line break. Returns false at the end of the stream.
bool read_line(std::FILE* from, std::string& line);

/// Returns the standard output of a program; nothing when its exit status is not 0.
std::optional<std::string> output_of(const std::vector<std::string>& words);

}  // namespace canproof::host
