// Nothing here may be flagged.
long seconds(const long one) { return one; }
