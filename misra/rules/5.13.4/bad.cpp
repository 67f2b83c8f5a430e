// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
unsigned mask() {
    return 0xFFFFFFFF;  // flagged
}
unsigned bits() {
    return 0b1000;  // flagged
}
