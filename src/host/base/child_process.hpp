// SPDX-License-Identifier: Apache-2.0
// Starts other programs without a shell.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/base/descriptor.hpp"

namespace canproof::host {

/// Descriptors for a program's standard input and output. -1 means /dev/null. When `out` is -1, standard error goes to
/// /dev/null too; otherwise the program inherits standard error.
struct Streams {
    int in{-1};
    int out{-1};
    bool apart{false};  ///< runs the program in its own process group, so that Ctrl-C at the terminal does not reach it
};

/// Throws InputError: the program `name` cannot be started, because of the error with this number of errno.
[[noreturn]] void refuse_to_start(const std::string& name, int error);

/// Starts a program. `words` contains the program (a path, or a name to find in PATH) and its arguments.
/// `more_environment` contains `NAME=value` elements, which override those of this program's environment. Throws
/// InputError when the program cannot be started.
pid_t start_process(const std::vector<std::string>& words, const std::vector<std::string>& more_environment,
                    Streams streams);
/// Waits for the end of a process; continues to wait when a signal interrupts the wait. Returns the exit status of the
/// process, or 128 plus the signal's number when a signal ended it. Throws InputError when `process` is no child of
/// this program.
int wait_for_process(pid_t process);
/// Waits for the end of a process and ignores its exit status, so that destructors can call it. Returns immediately
/// when `process` is no child of this program.
void reap_process(pid_t process) noexcept;

/// The two ends of a pipe.
struct Pipe {
    Descriptor reads;
    Descriptor writes;
};

/// Opens a pipe whose ends started programs do not inherit. Throws InputError when no pipe can be opened.
Pipe make_pipe();

struct CloseStream {
    void operator()(std::FILE* stream) const { static_cast<void>(std::fclose(stream)); }
};
/// A stream on one end of a pipe. Its destruction closes the descriptor.
using PipeStream = std::unique_ptr<std::FILE, CloseStream>;
/// Returns a stream with this mode of fdopen(). Throws InputError when there is no memory for it.
PipeStream open_stream(Descriptor end, const char* mode);
/// Reads the next line without its line break. Returns false when nothing is left in the stream.
bool read_line(std::FILE* from, std::string& line);

/// Runs a program to its end. Returns its standard output; returns nothing when its exit status is not 0. Throws
/// InputError when no pipe can be opened or the program cannot be started.
std::optional<std::string> output_of(const std::vector<std::string>& words);

}  // namespace canproof::host
