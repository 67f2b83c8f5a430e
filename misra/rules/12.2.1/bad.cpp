// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
struct Flags {
    unsigned first : 1;  // flagged
};
