// `canproof demo`: the manuals' worked examples, answered by the devices.
#pragma once

namespace canproof::host {

/// Prints each example with its answer. Returns the exit status, 0.
int play_examples();

}  // namespace canproof::host
