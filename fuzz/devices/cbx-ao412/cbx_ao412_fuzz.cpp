// SPDX-License-Identifier: Apache-2.0
// Fuzzes a whole CAN-CBX-AO412: support/device_world.hpp has the events and the properties that are checked.
#include "fuzz/devices/cbx-ao412/cbx_ao412_unit.hpp"
#include "fuzz/support/claims.hpp"
#include "fuzz/support/fuzz_device.hpp"
#include "fuzz/support/record_mutator.hpp"
#include "fuzz/support/replays_as.hpp"
#include "generated/canopen/requirements.hpp"
#include "generated/cbx_ao412/requirements.hpp"

using namespace canproof;

CANPROOF_FUZZ_REPLAYS_AS("cbx-ao412")
CANPROOF_FUZZ_RECORDS(fuzz::device_record_size)
CANPROOF_FUZZ_CLAIMS(req::CO_SDO_015, req::CO_SDO_044, req::CO_STORE_004)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return fuzz::fuzz_device<fuzz::CbxAo412Unit>(data, size);
}
