// Nothing here may be flagged.
const char* ask() { return "really?"; }
