// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int fail(const int value) noexcept {
    if (value > 3) {
        throw value;  // flagged
    }
    return value;
}
