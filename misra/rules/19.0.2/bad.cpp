// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#define TWICE(value) ((value) + (value))  // flagged
int now() { return TWICE(2); }
