// Each marked line must be flagged.
int count(const int value) {
    using Count = int;  // flagged
    return value;
}
