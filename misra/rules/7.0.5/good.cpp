// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
bool less(const unsigned one, const unsigned other) {
    return one < other;
}
bool within(const unsigned char value, const unsigned limit) {
    return value <= limit;
}
float scaled(const int value) {
    return static_cast<float>(value) * 2.0F;
}
unsigned turned(const unsigned char value) {
    return ~static_cast<unsigned>(value);
}
unsigned next(const unsigned value) {
    return value + 1;
}
void gather(unsigned char& count, unsigned& sum, const unsigned char value) {
    ++count;
    sum += value;
}
