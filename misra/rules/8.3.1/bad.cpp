// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
unsigned turned(const unsigned value) {
    return -value;  // flagged
}
