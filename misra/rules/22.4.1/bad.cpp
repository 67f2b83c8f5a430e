// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <cerrno>
void spoil() {
    errno = 3;  // flagged
}
