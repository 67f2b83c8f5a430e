// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
struct Flags {
    signed int sign : 1;  // flagged
};
