// Nothing here may be flagged.
int run() { return 0; }
