// Nothing here may be flagged.
struct Row {
    int first;
    int read() {
        const auto get = [this] { return first; };
        return get();
    }
};
