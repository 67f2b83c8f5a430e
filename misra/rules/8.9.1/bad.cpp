// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
bool before(const int* const one, const int* const other) {
    return one < other;  // flagged
}
