// SPDX-License-Identifier: Apache-2.0
// The checkers must report each line marked `flagged` for a review by a person.
constexpr unsigned few = 3U;
unsigned below() {
    return few - 4U;  // flagged
}
