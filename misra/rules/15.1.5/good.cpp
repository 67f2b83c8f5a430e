// Nothing here may be flagged.
struct Row {
    explicit Row(int size);
};
