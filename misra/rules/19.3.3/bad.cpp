// Each marked line must be flagged.
#define BOTH(value) (value) + value##1  // flagged
int now();
