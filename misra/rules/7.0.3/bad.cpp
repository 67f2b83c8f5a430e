// Each marked line must be flagged.
int digit(const char letter) {
    return letter - '0';  // flagged
}
