// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
bool some(const int count) {
    return count;  // flagged
}
bool set(const int* const place) {
    if (place) {  // flagged
        return true;
    }
    return false;
}
