// Nothing here may be flagged.
int one(const int value, const int) { return value; }
