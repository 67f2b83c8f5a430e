// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#define NAME(one, two) #one##two  // flagged
int now();
