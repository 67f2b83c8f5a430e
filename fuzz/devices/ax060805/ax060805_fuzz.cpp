// SPDX-License-Identifier: Apache-2.0
// Fuzzes a whole AX060805: support/device_world.hpp has the events and the properties that are checked.
#include "fuzz/devices/ax060805/ax060805_unit.hpp"
#include "fuzz/support/claims.hpp"
#include "fuzz/support/fuzz_device.hpp"
#include "fuzz/support/record_mutator.hpp"
#include "fuzz/support/replays_as.hpp"
#include "generated/ax060805/requirements.hpp"
#include "generated/canopen/requirements.hpp"

using namespace canproof;

CANPROOF_FUZZ_REPLAYS_AS("ax060805")
CANPROOF_FUZZ_RECORDS(fuzz::device_record_size)
CANPROOF_FUZZ_CLAIMS(req::INC_FV_002, req::INC_BIN_007, req::INC_INSTALL_005)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return fuzz::fuzz_device<fuzz::Ax060805Unit>(data, size);
}
