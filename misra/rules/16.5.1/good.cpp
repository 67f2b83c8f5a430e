// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
struct Flag {
    bool set;
};
bool operator==(const Flag& one, const Flag& other);
