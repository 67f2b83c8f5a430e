// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int next(const int count) {
    constexpr int step{1};
    return count + step;
}
