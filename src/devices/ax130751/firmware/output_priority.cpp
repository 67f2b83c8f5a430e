// SPDX-License-Identifier: Apache-2.0
#include "devices/ax130751/firmware/output_priority.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/ax130751/requirements.hpp"

namespace canproof::ax130751 {

static_assert(implements<req::AOR_OUT_007>);
OutputDrive choose_drive(const OutputConditions& conditions) noexcept {
    if (conditions.shutdown) {
        return OutputDrive::shutdown;
    }
    if (conditions.overridden) {
        return OutputDrive::override_value;
    }
    if (conditions.input_in_error && (conditions.enable == OutputDrive::control)) {
        return conditions.on_error;
    }
    return conditions.enable;
}

}  // namespace canproof::ax130751
