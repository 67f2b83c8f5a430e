// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#pragma GCC optimize("O0")  // flagged
int now();
