// Nothing here may be flagged.
int* at(int* const base, const int step) { return base + step; }
