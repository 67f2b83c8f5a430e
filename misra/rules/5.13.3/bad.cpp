// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int eight() {
    return 010;  // flagged
}
