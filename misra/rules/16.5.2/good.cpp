// Nothing here may be flagged.
struct Row {
    int* place();
};
