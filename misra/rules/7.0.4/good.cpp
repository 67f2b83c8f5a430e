// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
unsigned mask(const unsigned value) {
    return ~(value & 3U);
}
unsigned shifted(const unsigned value, const unsigned char by) {
    return (value << by) | (value >> 3);
}
