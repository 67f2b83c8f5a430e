// Nothing here may be flagged.
int tell() { return 1; }
