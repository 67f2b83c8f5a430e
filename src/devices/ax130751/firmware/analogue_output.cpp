// SPDX-License-Identifier: Apache-2.0
#include "devices/ax130751/firmware/analogue_output.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/ax130751/requirements.hpp"

namespace canproof::ax130751 {

static_assert(implements<req::AOR_OUT_009> && implements<req::AOR_OUT_010> && implements<req::AOR_OUT_011>);
AnalogueOutputState AnalogueOutput::advance(const OutputDrive drive, const AnalogueDemand& demand,
                                            const OutputRange& range, const RampTimes& times,
                                            const Instant now) noexcept {
    static_assert(implements<req::AOR_OUT_015>);
    constexpr double off = 0.0;
    double target{off};
    double value{off};
    static_assert(implements<req::AOR_OUT_014> && implements<req::AOR_DIAG_009> && implements<req::AOR_DIAG_020>);
    switch (drive) {
        case OutputDrive::control:
            target = range.nearest(demand.control);
            value = ramp_.follow(target, times, now);
            break;
        case OutputDrive::ramp_off:
            value = ramp_.follow(target, times, now);
            break;
        case OutputDrive::keep:
            static_assert(implements<req::AOR_OUT_042>);
            value = ramp_.hold(now);
            target = range.nearest(value);
            break;
        case OutputDrive::override_value:
            target = range.nearest(demand.override_value);
            ramp_.set(target);
            value = target;
            break;
        case OutputDrive::fault_value:
            target = range.nearest(demand.fault_value);
            ramp_.set(target);
            value = target;
            break;
        case OutputDrive::shut_off:
        case OutputDrive::shutdown:
        default:
            ramp_.set(target);
            break;
    }
    return AnalogueOutputState{target, range.nearest(value)};
}

}  // namespace canproof::ax130751
