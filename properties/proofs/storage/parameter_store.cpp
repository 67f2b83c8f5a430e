// SPDX-License-Identifier: Apache-2.0
// Theorems on the parameter store when the power fails during a save: afterwards it has the old set of values or the
// new one, never a mixture. The dictionary has one stored parameter of four bytes. A save of more parameters repeats
// the same steps.
#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/parameter_save.hpp"

namespace canproof::proofs {

void the_first_parameter_save_is_whole_or_not_at_all() {
    shows(
        "the first save of a parameter of four bytes, cut after any byte, loads as shipped or as saved, for any value");
    proves<req::CO_STORE_004>();
    cut_a_save_behind(0U);
}

}  // namespace canproof::proofs
