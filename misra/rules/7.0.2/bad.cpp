// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
bool some(const int count) {
    return count;  // flagged
}
bool set(const int* const place) {
    if (place) {  // flagged
        return true;
    }
    return false;
}
