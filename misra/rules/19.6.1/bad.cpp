// Each marked line must be flagged.
#pragma GCC optimize("O0")  // flagged
int now();
