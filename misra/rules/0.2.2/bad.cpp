// Each marked line must be flagged.
int one(const int value, const int other) {  // flagged
    return value;
}
