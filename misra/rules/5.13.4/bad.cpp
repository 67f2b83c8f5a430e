// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
unsigned mask() {
    return 0xFFFFFFFF;  // flagged
}
unsigned bits() {
    return 0b1000;  // flagged
}
