// Each marked line must be flagged.
long big() {
    return 1l;  // flagged
}
