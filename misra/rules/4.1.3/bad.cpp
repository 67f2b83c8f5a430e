// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int shares(const int value) {
    return value / 0;  // flagged
}
unsigned shifted(const unsigned value) {
    return value << 40U;  // flagged
}
int follow(const bool set, const int& other) {
    const int* place = nullptr;
    if (set) {
        place = &other;
    }
    return *place;  // flagged
}
