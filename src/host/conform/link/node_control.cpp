// SPDX-License-Identifier: Apache-2.0
#include "host/conform/link/node_control.hpp"

namespace canproof::host::conform {

void send_nmt(Link& link, NmtCommand command, std::uint8_t node) {
    Frame frame = data_frame(0U, 2U);
    frame.data[0] = static_cast<std::uint8_t>(command);
    frame.data[1] = node;
    link.send(frame);
}

std::optional<Instant> take_boot_up(Link& link, std::uint8_t node, Duration limit) {
    const Instant deadline = link.now() + limit;
    const FrameKey key{0x700U + node, false, false};
    for (auto record = link.take(key, deadline); record; record = link.take(key, deadline)) {
        if (record->frame.length == 1U && record->frame.data[0] == 0U) {
            return record->time;
        }
    }
    return std::nullopt;
}

}  // namespace canproof::host::conform
