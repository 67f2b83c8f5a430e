// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#define BOTH(value) (value) + value##1  // flagged
int now();
