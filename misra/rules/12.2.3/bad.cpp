// Each marked line must be flagged.
struct Flags {
    signed int sign : 1;  // flagged
};
