// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int whole(const double value) { return static_cast<int>(value); }
long wide(const int value) { return long{value}; }
