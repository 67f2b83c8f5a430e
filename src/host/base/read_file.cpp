// SPDX-License-Identifier: Apache-2.0
#include "host/base/read_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "host/base/descriptor.hpp"
#include "host/base/input_error.hpp"

namespace canproof::host {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why) {
    throw InputError{fmt::format("cannot read {}: {}", path.string(), why)};
}

std::string reason(int error) {
    return std::generic_category().message(error);
}

void wait_for_bytes(int file) {
    pollfd one{};
    one.fd = file;
    one.events = POLLIN;
    static_cast<void>(::poll(&one, 1, -1));
}

std::string read_to_end(int file, const std::filesystem::path& path, std::size_t most) {
    std::string text;
    std::array<char, 65536> piece;
    for (;;) {
        const ssize_t count = ::read(file, piece.data(), std::min(piece.size(), most - text.size() + 1));
        if (count > 0) {
            text.append(piece.data(), static_cast<std::size_t>(count));
            if (text.size() > most) {
                refuse(path, fmt::format("it has more than {} bytes; name a shorter file", most));
            }
        } else if (count == 0) {
            return text;
        } else if (errno == EAGAIN) {
            wait_for_bytes(file);
        } else if (errno != EINTR) {
            refuse(path, fmt::format("{}; name another file", reason(errno)));
        }
    }
}

}  // namespace

std::string read_file(const std::filesystem::path& path, std::size_t most) {
    const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)};
    if (!file.is_open()) {
        refuse(path, fmt::format("{}; name a file that exists and can be read", reason(errno)));
    }
    struct stat about {};
    if (::fstat(file.number(), &about) != 0) {
        refuse(path, fmt::format("{}; name another file", reason(errno)));
    }
    if (S_ISDIR(about.st_mode)) {
        refuse(path, "it is a folder; name a file");
    }
    if (S_ISREG(about.st_mode) && about.st_size > 0 && static_cast<std::size_t>(about.st_size) > most) {
        refuse(path, fmt::format("it has {} bytes, more than {}; name a shorter file", about.st_size, most));
    }
    std::string text = read_to_end(file.number(), path, most);
    if (text.empty() && S_ISFIFO(about.st_mode)) {
        refuse(path, "it is a pipe without a writer; name a file");
    }
    return text;
}

}  // namespace canproof::host
