// Nothing here may be flagged.
int read(const char letter) { return (letter == '1') ? 1 : 0; }
