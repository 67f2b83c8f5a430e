// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
struct Fault {};
int work();
int safe() {
    try {
        return work();
    } catch (Fault fault) {  // flagged
        return 0;
    }
}
