// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int one(const int value, const int) { return value; }
