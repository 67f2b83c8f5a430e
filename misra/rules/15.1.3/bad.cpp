// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
struct Count {
    Count(int value);      // flagged
    operator int() const;  // flagged
};
