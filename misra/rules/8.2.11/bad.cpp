// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int write(const char* text, ...);
int use() {
    return write("x", 3);  // flagged
}
