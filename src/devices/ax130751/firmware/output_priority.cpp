// SPDX-License-Identifier: Apache-2.0
#include "devices/ax130751/firmware/output_priority.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/ax130751/requirements.hpp"

namespace canproof::ax130751 {

namespace {

OutputDrive drive_of(const EnableAction action) noexcept {
    switch (action) {
        case EnableAction::run:
            return OutputDrive::control;
        case EnableAction::ramp_off:
            return OutputDrive::ramp_off;
        case EnableAction::keep:
            return OutputDrive::keep;
        case EnableAction::shut_off:
        default:
            return OutputDrive::shut_off;
    }
}

}  // namespace

static_assert(implements<req::AOR_OUT_007>);
OutputDrive choose_drive(const OutputConditions& conditions) noexcept {
    if (conditions.shutdown) {
        return OutputDrive::shutdown;
    }
    if (conditions.overridden) {
        return OutputDrive::override_value;
    }
    if (conditions.input_in_error && (conditions.enable == EnableAction::run)) {
        return (conditions.on_error == FaultAction::keep) ? OutputDrive::keep : OutputDrive::fault_value;
    }
    return drive_of(conditions.enable);
}

}  // namespace canproof::ax130751
