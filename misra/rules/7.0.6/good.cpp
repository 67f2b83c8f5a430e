// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
short small(const int value) { return static_cast<short>(value); }
long wide(const int value) { return value; }
