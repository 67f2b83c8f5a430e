// SPDX-License-Identifier: Apache-2.0
// The memory protection unit of ARMv7-M raises an exception at an access to protected memory. It protects the harness
// from a device with a fault. It also finds out whether the device uses a block of its RAM: an inverted bit has no
// effect as long as the device does not use its block.
#pragma once

#include <cstdint>

namespace canproof::faults {

constexpr std::uint32_t block_bytes = 32;  ///< the smallest block that the memory protection unit can protect

/// Protects the input, the record and the code of the harness (faults.ld) from writes. A device with a fault can
/// have switched the protection off, so each run starts with a call of this function.
void protect_harness();

/// Starts to watch the block of RAM at `address` and the block before it, until the first access to them. An access of
/// the harness counts as a use, too.
void watch_block(std::uint32_t address);
void end_watch();
/// Returns whether a block is watched that the device has not used yet. The march of the RAM's self-test does not count
/// as a use, because it does not depend on the contents and restores them.
bool is_unused();
/// Continues the watch after the march of the RAM's self-test.
void resume_watch();

}  // namespace canproof::faults
