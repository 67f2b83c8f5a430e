// Each marked line must be flagged.
int twice(int value) {
    return value + value++;  // flagged
}
