// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
struct Count {
    Count(int value);      // flagged
    operator int() const;  // flagged
};
