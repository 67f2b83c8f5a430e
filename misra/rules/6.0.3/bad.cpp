// Each marked line must be flagged.
int everywhere();  // flagged
