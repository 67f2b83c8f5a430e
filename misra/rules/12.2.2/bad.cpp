// Each marked line must be flagged.
struct Flags {
    char letter : 4;  // flagged
};
