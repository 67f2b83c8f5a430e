// Each marked line must be flagged.
int both(int one, const int other) {
    return one += 2, one + other;  // flagged
}
