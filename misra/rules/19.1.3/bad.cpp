// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#if UNKNOWN_NAME > 3  // flagged
#endif
int now();
