// Each marked line must be flagged.
int helper() { return 1; }  // flagged
