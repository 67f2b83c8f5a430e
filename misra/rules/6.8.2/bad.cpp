// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
const int& inner() {
    const int value{3};
    return value;  // flagged
}
