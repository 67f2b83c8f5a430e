// Nothing here may be flagged.
struct Flags {
    unsigned first;
};
