// SPDX-License-Identifier: Apache-2.0
#include "host/register/fault.hpp"

#include <fmt/format.h>

namespace canproof::host {

std::string Fault::text() const {
    // bytes of `what` that are printed, because a name in a message may have a million characters
    constexpr std::size_t longest = 1000;
    return fmt::format("{}:{}: {}{}; {}", place.file, place.line, what.substr(0, longest),
                       what.size() > longest ? "…" : "", fix);
}

}  // namespace canproof::host
