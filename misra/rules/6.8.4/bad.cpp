// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
struct Sum {
    int total;
    Sum& add(const int value) {  // flagged
        total += value;
        return *this;
    }
};
