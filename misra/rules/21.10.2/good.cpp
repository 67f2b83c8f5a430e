// Nothing here may be flagged.
int leave() { return 1; }
