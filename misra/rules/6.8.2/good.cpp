// Nothing here may be flagged.
const int& inner(const int& value) { return value; }
