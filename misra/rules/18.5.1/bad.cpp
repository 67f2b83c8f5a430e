// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int fail(const int value) noexcept {
    if (value > 3) {
        throw value;  // flagged
    }
    return value;
}
