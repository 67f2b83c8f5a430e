// Nothing here may be flagged.
struct Both {
    int whole;
    float real;
};
