// Each marked line must be flagged.
#define TWICE(value) value * 2  // flagged
int now() { return TWICE(1 + 2); }
