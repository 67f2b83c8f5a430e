// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
struct Flags {
    char letter : 4;  // flagged
};
