// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
struct Flag {
    bool set;
};
bool operator==(const Flag& one, const Flag& other);
