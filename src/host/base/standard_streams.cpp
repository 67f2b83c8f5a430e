// SPDX-License-Identifier: Apache-2.0
#include "host/base/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>

#include "host/base/input_error.hpp"

namespace canproof::host {

void keep_standard_descriptors() {
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(descriptor, F_GETFD) < 0) {
            // open() returns the lowest free descriptor, which is the closed one
            static_cast<void>(open("/dev/null", O_RDONLY));
        }
    }
}

void tell(const std::string& line) noexcept {
    std::fwrite(line.data(), 1, line.size(), stderr);
    std::fputc('\n', stderr);
}

void finish_standard_output() {
    std::cout.flush();
    std::fflush(stdout);
    if (standard_output_failed()) {
        throw InputError{
            "standard output cannot be written; check that it is open, that its disk has space and that its reader has "
            "not ended"};
    }
}

bool standard_output_failed() {
    return std::ferror(stdout) != 0 || !std::cout;
}

}  // namespace canproof::host
