// Each marked line must be flagged.
void fail(const int& value) {
    throw &value;  // flagged
}
