// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int work();
int main() {
    if (work() > 3) {
        throw 3;  // flagged
    }
    return 0;
}
