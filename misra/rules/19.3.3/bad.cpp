// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#define BOTH(value) (value) + value##1  // flagged
int now();
