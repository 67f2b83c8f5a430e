// Each marked line must be flagged.
long apart(const int* const one, const int* const other) {
    return one - other;  // flagged
}
