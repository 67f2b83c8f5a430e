// Each marked line must be flagged.
const char* ask() {
    return "really??!";  // flagged
}
