// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#define HAS defined(HERE)  // flagged
#if HAS
#endif
int now();
