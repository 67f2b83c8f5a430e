// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
struct Fault {};
int work();
int safe() {
    try {
        return work();
    } catch (Fault fault) {  // flagged
        return 0;
    }
}
