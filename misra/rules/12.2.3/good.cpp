// Nothing here may be flagged.
struct Flags {
    signed int sign;
};
