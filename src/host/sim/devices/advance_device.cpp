// SPDX-License-Identifier: Apache-2.0
#include "host/sim/devices/advance_device.hpp"

#include <fmt/format.h>

#include "host/base/time_text.hpp"

namespace canproof::host {

void advance_device(SimulatedDevice& device, const std::string& name, Instant now) {
    device.advance(now);
    if (device.next_deadline() <= now) {
        throw StuckDevice{
            fmt::format("{} does not advance at {} s: after advance(), its next_deadline() returns {} s; it must "
                        "return a later time",
                        name, format_seconds(now), format_seconds(device.next_deadline()))};
    }
}

}  // namespace canproof::host
