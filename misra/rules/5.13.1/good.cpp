// Nothing here may be flagged.
const char* path() { return "a\\qb\n"; }
