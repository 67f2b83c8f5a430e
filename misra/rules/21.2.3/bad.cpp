// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <cstdlib>
int run() {
    return std::system("ls");  // flagged
}
