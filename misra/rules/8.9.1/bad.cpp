// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
bool before(const int* const one, const int* const other) {
    return one < other;  // flagged
}
