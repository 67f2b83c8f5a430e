// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
const char* ask() {
    return "really??!";  // flagged
}
