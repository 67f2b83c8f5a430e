// Each marked line must be flagged.
int first(const int value) {
    return value;
    return value + 1;  // flagged
}
