// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int twice(const int value) { return 2 * value; }  // flagged
int counter = 0;                                  // flagged
