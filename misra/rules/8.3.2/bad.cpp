// Each marked line must be flagged.
int same(const int value) {
    return +value;  // flagged
}
