// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
struct Flag {
    bool set;
};
bool operator&&(const Flag& one, const Flag& other);  // flagged
