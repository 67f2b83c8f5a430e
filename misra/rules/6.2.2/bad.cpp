// Each marked line must be flagged.
extern short shared_count;  // flagged
