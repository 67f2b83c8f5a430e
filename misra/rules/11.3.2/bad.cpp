// Each marked line must be flagged.
int read(const int*** place);  // flagged
