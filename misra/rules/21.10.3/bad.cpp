// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <csignal>  // flagged
int shout() {
    return std::raise(SIGINT);  // flagged
}
