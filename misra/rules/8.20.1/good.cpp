// SPDX-License-Identifier: Apache-2.0
// Nothing here needs a person: an operand is no constant, or the arithmetic is signed.
unsigned next(const unsigned value) { return value + 1U; }
int below() { return 3 - 4; }
