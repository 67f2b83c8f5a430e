// Each marked line must be flagged.
struct Base {
    virtual int read(int value);
};
struct Derived : Base {
    int read(double value);  // flagged
};
