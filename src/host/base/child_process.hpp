// Other programs, started without a shell.
#pragma once

#include <sys/types.h>

#include <array>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace canproof::host {

/// Descriptors that become standard input and output of a program; -1: /dev/null, with its error output as well.
struct Streams {
    int in{-1};
    int out{-1};
    bool apart{false};  ///< in a process group of its own: Ctrl-C at the terminal does not reach it
};

/// `words`: a path, or a name to be found in PATH, and the arguments. `more_environment`: `NAME=value`, before ours.
/// Throws InputError when there is no such program.
pid_t start_process(const std::vector<std::string>& words, const std::vector<std::string>& more_environment,
                    Streams streams);
/// The exit status; 128 and more when a signal ended it.
int wait_for_process(pid_t process);

/// Both ends, closed in every program that is started. Throws InputError.
std::array<int, 2> make_pipe();
/// The next line without its end; false at the end of the stream.
bool read_line(std::FILE* from, std::string& line);

/// What a program prints; nothing when its exit status is not 0.
std::optional<std::string> output_of(const std::vector<std::string>& words);

}  // namespace canproof::host
