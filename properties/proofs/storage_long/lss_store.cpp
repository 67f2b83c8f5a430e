// SPDX-License-Identifier: Apache-2.0
// Theorem on a save of the LSS store over memory of any contents, whose proof takes minutes.
#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/lss_save.hpp"

namespace canproof::proofs {

void a_lss_save_is_whole_over_any_memory() {
    shows(
        "over memory of any contents that loads as not damaged, a save, cut after any byte, loads as before or as "
        "saved now, and as saved now when it is complete");
    proves<req::CO_LSS_016, req::CO_LSS_017, req::CO_LSS_020, req::CO_LSS_088>();
    const std::size_t cut = each(bytes_of_a_save + 1U);
    const LssConfiguration shipped = any_configuration();
    const LssConfiguration next = any_configuration();
    auto bytes = any<Memory::Bytes>();
    Memory memory{bytes};
    const LssConfiguration last = LssStore{memory}.load(shipped);
    assume(!last.damaged);
    cut_a_save(bytes, cut, shipped, last, next);
}

}  // namespace canproof::proofs
