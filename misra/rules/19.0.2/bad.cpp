// Each marked line must be flagged.
#define TWICE(value) ((value) + (value))  // flagged
int now() { return TWICE(2); }
