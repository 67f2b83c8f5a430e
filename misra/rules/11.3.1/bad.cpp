// Each marked line must be flagged.
int row[3];  // flagged
