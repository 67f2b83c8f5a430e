// SPDX-License-Identifier: Apache-2.0
#include "host/sim/devices/factory_key.hpp"

#include <fmt/ranges.h>

#include "host/register/literals.hpp"

namespace canproof::host {

std::string FactoryKey::range() const {
    if (!words.empty()) {
        return fmt::format("{}", fmt::join(words, ", "));
    }
    if (is_string_type(type)) {
        return fmt::format("1 … {} characters", length);
    }
    return integer_limits(type) ? fmt::format("{:.0f} … {:.0f}", minimum, maximum)
                                : fmt::format("{} … {}", minimum, maximum);
}

}  // namespace canproof::host
