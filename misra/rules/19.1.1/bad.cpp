// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#define HAS defined(HERE)  // flagged
#if HAS
#endif
int now();
