// Nothing here may be flagged.
const int* nothing() { return nullptr; }
