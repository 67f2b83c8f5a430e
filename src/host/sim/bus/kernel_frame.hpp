// SPDX-License-Identifier: Apache-2.0
// Converts frames, filters and error frames to and from the kernel's form (linux/can.h, linux/can/error.h).
#pragma once

#include <linux/can.h>

#include <optional>
#include <vector>

#include "firmware/canopen/node.hpp"
#include "host/sim/bus/acceptance.hpp"

namespace canproof::host {

can_frame to_kernel(const Frame& frame);
/// Converts a data frame or remote frame. A length above eight bytes becomes eight.
Frame from_kernel(const can_frame& frame);
bool is_error_frame(const can_frame& frame);

/// Returns the filters for CAN_RAW_FILTER. If there are more than the kernel accepts, returns one filter that accepts
/// every frame.
std::vector<can_filter> kernel_filters(const std::vector<AcceptanceFilter>& filters);

/// The information of an error frame about the controller.
struct ControllerNews {
    std::optional<CanState> state;  ///< new state of the controller; without a value the state has not changed
    bool overrun{false};
};

ControllerNews read_error_frame(const can_frame& frame);

}  // namespace canproof::host
