// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int read(const int value) {
    const auto get = [value] { return value + 1; };
    return get();
}
