// SPDX-License-Identifier: Apache-2.0
// Theorems on the LSS store when the power fails during a save: afterwards it has the old configuration or the new one,
// never a mixture.
#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/lss_save.hpp"

namespace canproof::proofs {

void the_first_lss_save_is_whole_or_not_at_all() {
    shows("the first save, cut after any byte, loads as shipped or as saved, for every node-ID and bit rate");
    proves<req::CO_LSS_016, req::CO_LSS_017, req::CO_LSS_020, req::CO_LSS_088>();
    cut_a_save_behind(0U);
}

void a_later_lss_save_is_whole_or_not_at_all() {
    shows("a save behind another, cut after any byte, loads as saved before or as saved now");
    proves<req::CO_LSS_016, req::CO_LSS_017, req::CO_LSS_020, req::CO_LSS_088>();
    cut_a_save_behind(1U);
}

}  // namespace canproof::proofs
