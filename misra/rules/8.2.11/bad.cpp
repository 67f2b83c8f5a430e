// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int write(const char* text, ...);
int use() {
    return write("x", 3);  // flagged
}
