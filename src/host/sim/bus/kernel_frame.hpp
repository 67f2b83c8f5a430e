// Frames, filters and error frames as the kernel writes them (linux/can.h, linux/can/error.h).
#pragma once

#include <linux/can.h>

#include <optional>
#include <vector>

#include "firmware/canopen/node.hpp"
#include "host/sim/bus/acceptance.hpp"

namespace canproof::host {

can_frame to_kernel(const Frame& frame);
/// Of a data or remote frame; more than eight bytes cannot be.
Frame from_kernel(const can_frame& frame);
bool is_error_frame(const can_frame& frame);

/// For CAN_RAW_FILTER. More than the kernel takes become one that lets all through.
std::vector<can_filter> kernel_filters(const std::vector<AcceptanceFilter>& filters);

/// What an error frame says about the controller.
struct ControllerNews {
    std::optional<CanState> state;  ///< nothing: as it was
    bool overrun{false};
};

ControllerNews read_error_frame(const can_frame& frame);

}  // namespace canproof::host
