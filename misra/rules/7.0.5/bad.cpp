// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
bool less(const unsigned char one, const unsigned char other) {
    return one < other;  // flagged
}
unsigned sum(const unsigned one, const int other) {
    return one + other;  // flagged
}
float scaled(const int value) {
    return value * 2.0F;  // flagged
}
int turned(const unsigned char value) {
    return ~value;  // flagged
}
unsigned shifted(const unsigned value, const unsigned char by) {
    return value >> by;  // flagged
}
int doubled(const unsigned short value) {
    return value << 1U;  // flagged
}
int chosen(const bool first, const unsigned char narrow, const unsigned short wide) {
    return first ? narrow : wide;  // flagged
}
void gather(unsigned char& sum, float& mean, const unsigned char value, const int whole) {
    sum += value;   // flagged
    sum >>= 1U;     // flagged
    mean += whole;  // flagged
}
