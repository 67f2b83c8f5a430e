// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int now() {
    // return 3;  // flagged
    return 4;
}
