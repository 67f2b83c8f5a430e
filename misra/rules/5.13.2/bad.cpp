// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
const char* bell() {
    return "\x07 bell";  // flagged
}
const char* old_bell() {
    return "\7 bell";  // flagged
}
