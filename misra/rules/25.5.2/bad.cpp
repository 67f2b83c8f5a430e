// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <cstdlib>
void spoil() {
    char* const home = std::getenv("HOME");  // flagged
    home[0] = 'x';
}
