// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
struct Count {
    int value;
    bool operator==(const Count& other) const;  // flagged
};
