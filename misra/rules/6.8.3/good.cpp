// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
struct Holder {
    const int* place;
    void keep(const int& value) { place = &value; }
};
