// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
long apart(const int* const one, const int* const other) {
    return one - other;  // flagged
}
