// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
unsigned long long address(const int* const place) {
    return reinterpret_cast<unsigned long long>(place);  // flagged
}
