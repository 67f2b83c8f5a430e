// Each marked line must be flagged.
bool less(const unsigned char one, const unsigned char other) {
    return one < other;  // flagged
}
unsigned sum(const unsigned one, const int other) {
    return one + other;  // flagged
}
float scaled(const int value) {
    return value * 2.0F;  // flagged
}
