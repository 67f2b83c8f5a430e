// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#if 0
#elsif 1  // flagged
#endif
int now();
