// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
const char* bell() {
    return "\x07 bell";  // flagged
}
const char* old_bell() {
    return "\7 bell";  // flagged
}
