// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
using One = int (*)();
using Other = void (*)(int);
Other turn(const One one) {
    return reinterpret_cast<Other>(one);  // flagged
}
