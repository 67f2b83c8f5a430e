// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int whole(const double value) {
    return (int)value;  // flagged
}
int whole_too(const double value) {
    return int(value);  // flagged
}
