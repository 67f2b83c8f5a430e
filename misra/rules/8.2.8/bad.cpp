// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
unsigned long long address(const int* const place) {
    return reinterpret_cast<unsigned long long>(place);  // flagged
}
