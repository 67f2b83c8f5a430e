// Nothing here may be flagged.
struct Row {
    int first;
    explicit Row(int value) noexcept : first{value} {}
};
