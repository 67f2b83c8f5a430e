// Each marked line must be flagged.
extern int row[];  // flagged
