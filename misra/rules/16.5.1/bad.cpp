// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
struct Flag {
    bool set;
};
bool operator&&(const Flag& one, const Flag& other);  // flagged
