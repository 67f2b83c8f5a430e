// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
struct Row {
    int first;
    explicit Row(int value) try : first{value} {  // flagged
    } catch (...) {
    }
};
