// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
struct Holder {
    const int* place;
    void keep() {
        const int value{3};
        place = &value;  // flagged
    }
};
