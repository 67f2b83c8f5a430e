// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <csignal>  // flagged
int shout() {
    return std::raise(SIGINT);  // flagged
}
