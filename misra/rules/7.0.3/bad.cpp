// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int digit(const char letter) {
    return letter - '0';  // flagged
}
