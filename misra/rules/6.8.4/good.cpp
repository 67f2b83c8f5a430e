// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
struct Sum {
    int total;
    void add(const int value) { total += value; }
};
