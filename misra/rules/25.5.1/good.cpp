// Nothing here may be flagged.
char decimal_point() { return '.'; }
