// Each marked line must be flagged.
void fail() {
    throw;  // flagged
}
