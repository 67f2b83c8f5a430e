// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int* at(const unsigned long address) {
    return reinterpret_cast<int*>(address);  // flagged
}
