// Each marked line must be flagged.
union Both {  // flagged
    int whole;
    float real;
};
