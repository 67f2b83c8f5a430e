// Nothing here may be flagged.
int sum(const int one, const int two, const int three) { return one + (two * three); }
