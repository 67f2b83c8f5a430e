// Each marked line must be flagged.
[[noreturn]] void stop(const bool now) {
    while (now) {
    }
}  // flagged
