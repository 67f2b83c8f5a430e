// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
struct Unknown;
void drop(Unknown* const place) {
    delete place;  // flagged
}
