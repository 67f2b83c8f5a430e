// Nothing here may be flagged.
[[noreturn]] void stop();
void go(const bool now) {
    if (now) {
        stop();
    }
}
