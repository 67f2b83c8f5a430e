// SPDX-License-Identifier: Apache-2.0
// Fuzzes a whole AX130751: support/device_world.hpp has the events and the properties that are checked.
#include "fuzz/devices/ax130751/ax130751_unit.hpp"
#include "fuzz/support/claims.hpp"
#include "fuzz/support/fuzz_device.hpp"
#include "fuzz/support/record_mutator.hpp"
#include "fuzz/support/replays_as.hpp"
#include "generated/ax130751/requirements.hpp"
#include "generated/canopen/requirements.hpp"

using namespace canproof;

CANPROOF_FUZZ_REPLAYS_AS("ax130751")
CANPROOF_FUZZ_RECORDS(fuzz::device_record_size)
CANPROOF_FUZZ_CLAIMS(req::AOR_OUT_016, req::AOR_DIAG_008, req::AOR_RELAY_001, req::CO_SDO_015, req::CO_SDO_044,
                     req::CO_STORE_004)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return fuzz::fuzz_device<fuzz::Ax130751Unit>(data, size);
}
