// Each marked line must be flagged.
struct Row {
    int* operator&();  // flagged
};
