// SPDX-License-Identifier: Apache-2.0
// Fuzzes a whole AX188001: support/device_world.hpp has the events and the properties that are checked.
#include "fuzz/devices/ax188001/ax188001_unit.hpp"
#include "fuzz/support/claims.hpp"
#include "fuzz/support/fuzz_device.hpp"
#include "fuzz/support/record_mutator.hpp"
#include "fuzz/support/replays_as.hpp"
#include "generated/ax188001/requirements.hpp"
#include "generated/canopen/requirements.hpp"

using namespace canproof;

CANPROOF_FUZZ_REPLAYS_AS("ax188001")
CANPROOF_FUZZ_RECORDS(fuzz::device_record_size)
CANPROOF_FUZZ_CLAIMS(req::TCS_VAL_007, req::TCS_LIM_008, req::TCS_FD_006)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return fuzz::fuzz_device<fuzz::Ax188001Unit>(data, size);
}
