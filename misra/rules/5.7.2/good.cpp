// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int now() {
    // A comment (also one with parentheses) is no code;
    // not even if it ends with a semicolon.
    return 4;
}
