// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int call(int one, int other);
int both(const int one, const int other) { return call(one, other); }
