// SPDX-License-Identifier: Apache-2.0
// Theorem on a save of the parameter store behind another save, whose proof takes minutes.
#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/parameter_save.hpp"

namespace canproof::proofs {

void a_later_parameter_save_is_whole_or_not_at_all() {
    shows("a save behind another, cut after any byte, loads as saved before or as saved now, for any values");
    proves<req::CO_STORE_004>();
    cut_a_save_behind(1U);
}

}  // namespace canproof::proofs
