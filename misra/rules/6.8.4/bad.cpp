// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
struct Sum {
    int total;
    Sum& add(const int value) {  // flagged
        total += value;
        return *this;
    }
};
