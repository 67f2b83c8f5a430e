// Each marked line must be flagged.
const char* path() {
    return "a\qb";  // flagged
}
