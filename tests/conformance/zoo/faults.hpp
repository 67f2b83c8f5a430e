// SPDX-License-Identifier: Apache-2.0
// The table of all deliberate faults that a slave of the conformance tests can have (the "zoo").
#pragma once

#include "tests/conformance/zoo/fault.hpp"

namespace canproof::test::zoo {

Faults sdo_faults();
Faults sdo_frame_faults();
Faults sdo_transfer_faults();
Faults sdo_block_faults();
Faults dictionary_faults();
Faults nmt_faults();
Faults heartbeat_faults();
Faults guarding_faults();
Faults emcy_faults();
Faults sync_faults();
Faults transmit_pdo_faults();
Faults transmit_pdo_parameter_faults();
Faults receive_pdo_faults();
Faults mapping_faults();
Faults lss_faults();
Faults lss_setting_faults();
Faults store_faults();

/// Returns all faults, in the order of the functions above.
const Faults& all_faults();

}  // namespace canproof::test::zoo
