// SPDX-License-Identifier: Apache-2.0
#include "host/sim/bus/bus.hpp"

#include <utility>

namespace canproof::host {

void Bus::use_clock(ArrivalClock::Clock clock) {
    arrival_clock_.use(std::move(clock));
}

void Bus::listen(FrameListener listener) {
    listener_ = std::move(listener);
}

void Bus::on_notice(NoticeListener listener) {
    notice_ = std::move(listener);
}

void Bus::tell(const BusFrame& frame) const {
    if (listener_) {
        listener_(frame);
    }
}

void Bus::notice(const std::string& text) const {
    if (notice_) {
        notice_(text);
    }
}

}  // namespace canproof::host
