// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
struct Holder {
    const int* place;
    void keep() {
        const int value{3};
        place = &value;  // flagged
    }
};
