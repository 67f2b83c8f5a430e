// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
struct Count {
    int value;
    bool operator==(const Count& other) const;  // flagged
};
