// SPDX-License-Identifier: Apache-2.0
#include "host/sim/devices/node_id.hpp"

#include <fmt/format.h>

#include "host/base/input_error.hpp"

namespace canproof::host {

std::string node_id_words() {
    return fmt::format("{}…{}, or {} for a device to which LSS has to assign a node-ID", NodeId::lowest,
                       NodeId::highest, NodeId::none);
}

NodeId::NodeId(int number) : value_{static_cast<std::uint8_t>(number)} {
    if (!is_one(number)) {
        throw InputError{fmt::format("{} is no node-ID; write {}", number, node_id_words())};
    }
}

}  // namespace canproof::host
