// SPDX-License-Identifier: Apache-2.0
// No line needs a review, because one operand is not a constant or the arithmetic is signed.
unsigned next(const unsigned value) { return value + 1U; }
int below() { return 3 - 4; }
