// Each marked line must be flagged.
const char16_t* name() {
    return "a" u"b";  // flagged
}
