// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#define TWICE(value) ((value) + (value))  // flagged
int now() { return TWICE(2); }
