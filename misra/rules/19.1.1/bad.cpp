// Each marked line must be flagged.
#define HAS defined(HERE)  // flagged
#if HAS
#endif
int now();
