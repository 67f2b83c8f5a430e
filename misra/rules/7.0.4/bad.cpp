// Each marked line must be flagged.
int mask(const int value) {
    return value & 3;  // flagged
}
int turned(const unsigned char value) {
    return ~value;  // flagged
}
