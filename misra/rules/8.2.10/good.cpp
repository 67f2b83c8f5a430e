// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int factorial(const int value) {
    int product{1};
    for (int i = 2; i <= value; ++i) {
        product *= i;
    }
    return product;
}
