// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
struct Lock {};
int held() {
    Lock lock();  // flagged
    return 3;
}
