// SPDX-License-Identifier: Apache-2.0
// `canproof demo`: the devices answer the worked examples of their manuals.
#pragma once

namespace canproof::host {

/// Prints each example with its answer. Returns the exit status, which is always 0.
int play_examples();

}  // namespace canproof::host
