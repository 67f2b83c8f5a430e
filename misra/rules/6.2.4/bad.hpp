// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int twice(const int value) { return 2 * value; }  // flagged
int counter = 0;                                  // flagged
