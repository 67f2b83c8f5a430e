// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
struct Unknown;
void drop(Unknown* const place) {
    delete place;  // flagged
}
