// SPDX-License-Identifier: Apache-2.0
#include "host/base/dependent_process.hpp"

#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

#include "host/base/child_process.hpp"

namespace canproof::host {

namespace {

/// Becomes the program in a new process. Sends errno to `failed` when this is impossible. Calls only functions that a
/// process may call after fork().
[[noreturn]] void become(char* const* words, int in, int out, int failed, pid_t parent) {
    const bool bound = prctl(PR_SET_PDEATHSIG, SIGKILL) == 0;
    if (getppid() != parent) {
        _exit(1);  // the parent has ended before the kernel knew that this process must end with it
    }
    if (bound && setpgid(0, 0) == 0 && dup2(in, STDIN_FILENO) >= 0 && dup2(out, STDOUT_FILENO) >= 0) {
        execvp(words[0], words);
    }
    const int error = errno;
    _exit(write(failed, &error, sizeof error) == sizeof error ? 1 : 2);
}

}  // namespace

pid_t start_dependent_process(const std::vector<std::string>& words, int in, int out) {
    std::vector<char*> pointers;
    for (const auto& word : words) {
        pointers.push_back(const_cast<char*>(word.c_str()));
    }
    pointers.push_back(nullptr);
    Pipe failed = make_pipe();
    const pid_t parent = getpid();
    const pid_t process = fork();
    if (process == 0) {
        become(pointers.data(), in, out, failed.writes.number(), parent);
    }
    int error = process < 0 ? errno : 0;
    failed.writes = {};  // the read below then ends when the program has started
    if (process > 0 && read(failed.reads.number(), &error, sizeof error) == sizeof error) {
        reap_process(process);
    }
    if (error != 0) {
        refuse_to_start(words.front(), error);
    }
    return process;
}

}  // namespace canproof::host
