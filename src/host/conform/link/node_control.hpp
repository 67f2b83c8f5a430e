// SPDX-License-Identifier: Apache-2.0
// Sends NMT commands, and waits for the boot-up message after a reset.
#pragma once

#include <cstdint>
#include <optional>

#include "host/conform/link/link.hpp"

namespace canproof::host::conform {

enum class NmtCommand : std::uint8_t {
    start = 0x01,
    stop = 0x02,
    pre_operational = 0x80,
    reset_node = 0x81,
    reset_communication = 0x82
};

/// Longest time that a slave may take to boot.
constexpr Duration boot_limit = milliseconds(5000);

/// Sends an NMT command to `node`; 0 means all nodes.
void send_nmt(Link& link, NmtCommand command, std::uint8_t node);
/// Waits for the boot-up message and drops heartbeats that come before it. Returns the time at which the message was on
/// the bus; nothing when none comes within `limit`.
std::optional<Instant> take_boot_up(Link& link, std::uint8_t node, Duration limit = boot_limit);

}  // namespace canproof::host::conform
