// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#define TWICE(value) value * 2  // flagged
int now() { return TWICE(1 + 2); }
