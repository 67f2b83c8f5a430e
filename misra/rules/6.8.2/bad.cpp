// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
const int& inner() {
    const int value{3};
    return value;  // flagged
}
