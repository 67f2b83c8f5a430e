// Each marked line must be flagged.
#undef NULL  // flagged
int now();
