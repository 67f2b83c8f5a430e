// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
unsigned turned(const unsigned value) {
    return -value;  // flagged
}
