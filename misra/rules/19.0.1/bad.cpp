// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#if 0
#elsif 1  // flagged
#endif
int now();
