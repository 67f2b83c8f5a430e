// Each marked line must be flagged.
int eight() {
    return 010;  // flagged
}
