// SPDX-License-Identifier: Apache-2.0
#include "tests/conformance/zoo/faults.hpp"

namespace canproof::test::zoo {

const Faults& all_faults() {
    static const Faults all = [] {
        Faults joined;
        for (const auto& make : {sdo_faults, sdo_frame_faults, sdo_transfer_faults, sdo_block_faults, dictionary_faults,
                                 nmt_faults, heartbeat_faults, guarding_faults, emcy_faults, sync_faults,
                                 transmit_pdo_faults, transmit_pdo_parameter_faults, receive_pdo_faults, mapping_faults,
                                 lss_faults, lss_setting_faults, store_faults}) {
            for (Fault& fault : make()) {
                joined.push_back(std::move(fault));
            }
        }
        return joined;
    }();
    return all;
}

}  // namespace canproof::test::zoo
