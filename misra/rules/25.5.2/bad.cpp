// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <cstdlib>
void spoil() {
    char* const home = std::getenv("HOME");  // flagged
    home[0] = 'x';
}
