// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
struct Flags {
    unsigned first : 1;  // flagged
};
