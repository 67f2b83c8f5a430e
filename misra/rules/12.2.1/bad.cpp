// Each marked line must be flagged.
struct Flags {
    unsigned first : 1;  // flagged
};
