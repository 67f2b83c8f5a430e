// SPDX-License-Identifier: Apache-2.0
#include "host/base/write_all.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstddef>

namespace canproof::host {

bool write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR) {
            return false;
        }
        bytes.remove_prefix(count < 0 ? 0U : static_cast<std::size_t>(count));
    }
    return true;
}

}  // namespace canproof::host
