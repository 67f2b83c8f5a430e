// Each marked line must be flagged.
unsigned turned(const unsigned value) {
    return -value;  // flagged
}
