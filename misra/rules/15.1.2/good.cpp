// Nothing here may be flagged.
struct Base {
    Base();
};
struct Derived : Base {
    explicit Derived(int value) : Base{}, kept{value} {}
    int kept;
};
