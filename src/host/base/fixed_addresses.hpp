// SPDX-License-Identifier: Apache-2.0
// Fixes the addresses of this program's memory.
#pragma once

namespace canproof::host {

/// Starts this program again, with the same arguments, but without randomised addresses. Returns when the addresses are
/// already fixed, or when the kernel refuses (the default profile of some containers does).
void fix_addresses();

}  // namespace canproof::host
