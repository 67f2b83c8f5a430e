// Nothing here may be flagged.
const int* before(const int* const one) { return one - 1; }
