// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#define TWICE(value) value * 2  // flagged
int now() { return TWICE(1 + 2); }
