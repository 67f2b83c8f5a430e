// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int work();
int main() {
    if (work() > 3) {
        throw 3;  // flagged
    }
    return 0;
}
