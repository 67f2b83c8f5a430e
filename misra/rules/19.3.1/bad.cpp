// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#define NAME(value) #value  // flagged
const char* now() { return NAME(word); }
