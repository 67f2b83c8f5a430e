// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
struct Count {
    int value;
    Count operator-() const;
};
bool operator==(const Count& one, const Count& other);
