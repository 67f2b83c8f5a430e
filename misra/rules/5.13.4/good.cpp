// Nothing here may be flagged.
unsigned mask() { return 0xFFFFFFFFU; }
