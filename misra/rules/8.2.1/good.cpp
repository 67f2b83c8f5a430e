// Nothing here may be flagged.
struct Base {
    virtual ~Base();
};
struct Derived : Base {};
