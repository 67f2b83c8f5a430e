// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#if 1    // flagged
#endif   // flagged
int now();
