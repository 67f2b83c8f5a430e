// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int digit(const char letter) {
    return letter - '0';  // flagged
}
