// Each marked line must be flagged.
struct Base {
    virtual ~Base();
};
struct Derived : virtual Base {  // flagged
};
