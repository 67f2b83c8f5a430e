// Nothing here may be flagged.
bool digit(const char letter) { return (letter >= '0') && (letter <= '9'); }
