// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#define NAME(one, two) #one##two  // flagged
int now();
