// Nothing here may be flagged.
int read(int value);
