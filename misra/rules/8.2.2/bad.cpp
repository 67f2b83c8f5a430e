// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int whole(const double value) {
    return (int)value;  // flagged
}
int whole_too(const double value) {
    return int(value);  // flagged
}
