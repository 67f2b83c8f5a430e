// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
struct Row {
    int first;
    explicit Row(int value) try : first{value} {  // flagged
    } catch (...) {
    }
};
