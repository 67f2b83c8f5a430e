// Each marked line must be flagged.
int unset() {
    int value;
    return value;  // flagged
}
