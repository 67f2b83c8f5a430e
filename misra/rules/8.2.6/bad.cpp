// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int* at(const unsigned long address) {
    return reinterpret_cast<int*>(address);  // flagged
}
