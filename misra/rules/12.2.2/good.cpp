// Nothing here may be flagged.
struct Flags {
    char letter;
};
