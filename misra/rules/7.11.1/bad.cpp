// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
const int* nothing() {
    return 0;  // flagged
}
