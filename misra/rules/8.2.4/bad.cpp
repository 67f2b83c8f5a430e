// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
using One = int (*)();
using Other = void (*)(int);
Other turn(const One one) {
    return reinterpret_cast<Other>(one);  // flagged
}
