// Each marked line must be flagged.
#if UNKNOWN_NAME > 3  // flagged
#endif
int now();
