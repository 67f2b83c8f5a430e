// SPDX-License-Identifier: Apache-2.0
#include "host/sim/bus/kernel_frame.hpp"

#include <linux/can/error.h>
#include <linux/can/raw.h>

#include <algorithm>

namespace canproof::host {

can_frame to_kernel(const Frame& frame) {
    can_frame out{};
    out.can_id = frame.id | (frame.extended ? CAN_EFF_FLAG : 0U) | (frame.remote ? CAN_RTR_FLAG : 0U);
    out.can_dlc = frame.length;
    if (!frame.remote) {
        std::copy_n(frame.data.begin(), frame.length, out.data);
    }
    return out;
}

Frame from_kernel(const can_frame& frame) {
    Frame out{};
    out.extended = (frame.can_id & CAN_EFF_FLAG) != 0U;
    out.remote = (frame.can_id & CAN_RTR_FLAG) != 0U;
    out.id = frame.can_id & (out.extended ? CAN_EFF_MASK : CAN_SFF_MASK);
    out.length = static_cast<std::uint8_t>(std::min<std::size_t>(frame.can_dlc, max_frame_length));
    if (!out.remote) {
        std::copy_n(frame.data, out.length, out.data.begin());
    }
    return out;
}

bool is_error_frame(const can_frame& frame) {
    return (frame.can_id & CAN_ERR_FLAG) != 0U;
}

std::vector<can_filter> kernel_filters(const std::vector<AcceptanceFilter>& filters) {
    std::vector<can_filter> out;
    for (const AcceptanceFilter& one : filters) {
        const std::uint32_t format = one.extended ? CAN_EFF_FLAG : 0U;
        out.push_back({one.id | format, one.mask | CAN_EFF_FLAG});
    }
    if (out.size() > CAN_RAW_FILTER_MAX) {
        out.assign(1, can_filter{0U, 0U});
    }
    return out;
}

ControllerNews read_error_frame(const can_frame& frame) {
    ControllerNews news;
    if ((frame.can_id & CAN_ERR_CRTL) != 0U) {
        const std::uint8_t said = frame.data[1];
        news.overrun = (said & (CAN_ERR_CRTL_RX_OVERFLOW | CAN_ERR_CRTL_TX_OVERFLOW)) != 0;
        if ((said & (CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE)) != 0) {
            news.state = CanState::error_passive;
        } else if ((said & (CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_WARNING)) != 0) {
            news.state = CanState::warning;
        } else if ((said & CAN_ERR_CRTL_ACTIVE) != 0) {
            news.state = CanState::error_active;
        }
    }
    if ((frame.can_id & CAN_ERR_RESTARTED) != 0U) {
        news.state = CanState::error_active;
    }
    if ((frame.can_id & CAN_ERR_BUSOFF) != 0U) {
        news.state = CanState::bus_off;
    }
    return news;
}

}  // namespace canproof::host
