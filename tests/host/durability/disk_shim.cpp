// SPDX-License-Identifier: Apache-2.0
// A disk that fails on demand, loaded before the C library (LD_PRELOAD): the program under test is unchanged.
//
// Counts the calls that change, synchronise or lock a file below DURABILITY_FOLDER, or open a folder there. At call
// number DURABILITY_AT it performs DURABILITY_DO:
//   before     kill the program before the call
//   half       do half of a write, or all of another call, and kill the program
//   after      do the call and kill the program
//   once:ERR   fail with that errno at this call only
//   on:ERR     fail with that errno from this call on; a write first writes half
// DURABILITY_TRACE is a file that gets the name of each counted call.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdlib>
#include <cstring>

namespace {

enum class Deed { nothing, before, half, after, once, on };

struct Plan {
    const char* folder{std::getenv("DURABILITY_FOLDER")};
    long at{0};
    Deed deed{Deed::nothing};
    int error{0};
    int trace{-1};
    long count{0};
    std::array<bool, 1024> watched{};
};

Plan read_plan() {
    Plan plan;
    const char* at = std::getenv("DURABILITY_AT");
    plan.at = at == nullptr ? 0 : std::atol(at);
    const char* text = std::getenv("DURABILITY_DO");
    struct Name {
        const char* text;
        Deed deed;
    };
    for (const Name& name : {Name{"before", Deed::before}, Name{"half", Deed::half}, Name{"after", Deed::after},
                             Name{"once:", Deed::once}, Name{"on:", Deed::on}}) {
        if (text != nullptr && std::strncmp(text, name.text, std::strlen(name.text)) == 0) {
            plan.deed = name.deed;
            plan.error = std::atoi(text + std::strlen(name.text));
        }
    }
    if (const char* path = std::getenv("DURABILITY_TRACE"); path != nullptr) {
        plan.trace =
            static_cast<int>(syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644));
    }
    return plan;
}

Plan& plan() {
    static Plan only = read_plan();
    return only;
}

bool is_below(const char* path) {
    const char* folder = plan().folder;
    return folder != nullptr && path != nullptr && std::strncmp(path, folder, std::strlen(folder)) == 0;
}

bool is_watched(int file) {
    return file >= 0 && static_cast<std::size_t>(file) < plan().watched.size() &&
           plan().watched[static_cast<std::size_t>(file)];
}

[[noreturn]] void die() {
    syscall(SYS_kill, getpid(), SIGKILL);
    for (;;) {
        pause();
    }
}

/// Counts a call. `whole` performs the call, `half` a part of it; both return the result of the call.
template <typename Whole, typename Half>
auto counted(const char* name, Whole whole, Half half) -> decltype(whole()) {
    Plan& now = plan();
    ++now.count;
    if (now.trace >= 0) {
        syscall(SYS_write, now.trace, name, std::strlen(name));
        syscall(SYS_write, now.trace, "\n", 1);
    }
    const bool is_here = now.count == now.at;
    const bool is_behind = now.at > 0 && now.count > now.at;
    if (is_here && now.deed == Deed::before) {
        die();
    }
    if (is_here && now.deed == Deed::half) {
        half();
        die();
    }
    if ((is_here && now.deed == Deed::once) || ((is_here || is_behind) && now.deed == Deed::on)) {
        if (is_here && now.deed == Deed::on && std::strcmp(name, "write") == 0) {
            half();
        }
        errno = now.error;
        return -1;
    }
    const auto result = whole();
    if (is_here && now.deed == Deed::after) {
        die();
    }
    return result;
}

template <typename Whole>
auto counted(const char* name, Whole whole) -> decltype(whole()) {
    return counted(name, whole, whole);
}

template <typename Function>
Function* next(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

int open_file(int folder, const char* path, int flags, mode_t mode) {
    const auto real = [&] { return static_cast<int>(syscall(SYS_openat, folder, path, flags, mode)); };
    if (!is_below(path)) {
        return real();
    }
    const bool changes = (flags & (O_CREAT | O_TRUNC)) != 0 || (flags & O_DIRECTORY) != 0;
    const int file = changes ? counted("open", real) : real();
    if (file >= 0 && static_cast<std::size_t>(file) < plan().watched.size()) {
        plan().watched[static_cast<std::size_t>(file)] = true;
    }
    return file;
}

mode_t mode_of(int flags, va_list arguments) {
    return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(arguments, mode_t) : 0;
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = mode_of(flags, arguments);
    va_end(arguments);
    return open_file(AT_FDCWD, path, flags, mode);
}

int open64(const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = mode_of(flags, arguments);
    va_end(arguments);
    return open_file(AT_FDCWD, path, flags, mode);
}

int openat(int folder, const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = mode_of(flags, arguments);
    va_end(arguments);
    return open_file(folder, path, flags, mode);
}

int close(int file) {
    if (is_watched(file)) {
        plan().watched[static_cast<std::size_t>(file)] = false;
    }
    return static_cast<int>(syscall(SYS_close, file));
}

ssize_t write(int file, const void* bytes, size_t size) {
    const auto whole = [&] { return static_cast<ssize_t>(syscall(SYS_write, file, bytes, size)); };
    const auto half = [&] { return static_cast<ssize_t>(syscall(SYS_write, file, bytes, size / 2)); };
    return is_watched(file) ? counted("write", whole, half) : whole();
}

int fsync(int file) {
    const auto real = [&] { return static_cast<int>(syscall(SYS_fsync, file)); };
    return is_watched(file) ? counted("fsync", real) : real();
}

int fchmod(int file, mode_t mode) noexcept {
    const auto real = [&] { return static_cast<int>(syscall(SYS_fchmod, file, mode)); };
    return is_watched(file) ? counted("fchmod", real) : real();
}

int ftruncate(int file, off_t size) noexcept {
    const auto real = [&] { return static_cast<int>(syscall(SYS_ftruncate, file, size)); };
    return is_watched(file) ? counted("ftruncate", real) : real();
}

int flock(int file, int operation) noexcept {
    const auto real = [&] { return static_cast<int>(syscall(SYS_flock, file, operation)); };
    return is_watched(file) ? counted("flock", real) : real();
}

int rename(const char* from, const char* to) noexcept {
    const auto real = [&] { return next<int(const char*, const char*)>("rename")(from, to); };
    return is_below(to) ? counted("rename", real) : real();
}

int link(const char* from, const char* to) noexcept {
    const auto real = [&] { return next<int(const char*, const char*)>("link")(from, to); };
    return is_below(to) ? counted("link", real) : real();
}

int unlink(const char* path) noexcept {
    const auto real = [&] { return next<int(const char*)>("unlink")(path); };
    return is_below(path) ? counted("unlink", real) : real();
}

int remove(const char* path) noexcept {
    const auto real = [&] { return next<int(const char*)>("remove")(path); };
    return is_below(path) ? counted("remove", real) : real();
}

}  // extern "C"
