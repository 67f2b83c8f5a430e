// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int mask(const int value) {
    return value & 3;  // flagged
}
int turned(const int value) {
    return ~value;  // flagged
}
unsigned shifted(const unsigned value, const int by) {
    return value << by;  // flagged
}
int halved(const int value) {
    return value >> 1U;  // flagged
}
unsigned joined(const unsigned char one, const unsigned char two, const unsigned char three) {
    return static_cast<unsigned>((one | two) | three);  // flagged
}
