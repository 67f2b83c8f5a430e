// Each marked line must be flagged.
int read(const volatile int& place);  // flagged
