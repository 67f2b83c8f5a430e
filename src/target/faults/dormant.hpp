// SPDX-License-Identifier: Apache-2.0
// Shortens the run of a fault in RAM that the device does not use any more. Such a run is equal to the record up to the
// end of the workload, except for the inverted bit. The first run in which the device does not use a block goes to the
// end of the workload, with a watch on the block (watch.hpp). Later runs with a fault in the same block end at once.
#pragma once

#include <cstdint>

namespace canproof::faults {

/// Takes from the input what earlier emulators of this campaign have found out.
void load_dormancy();
/// Looks at the state after `pass`. `address` and `bit` are those of the inverted bit. Returns whether the rest of the
/// run is known: the state differs from the record only in this bit, and the device does not use its block up to the
/// end of the workload. If it is not known, watches the block from the next pass on.
bool is_dormant(std::uint32_t address, std::uint32_t bit, std::uint32_t pass);
/// Remembers at the end of the workload that the device did not use the watched block, and says so to the script `run`.
void end_dormancy();

}  // namespace canproof::faults
