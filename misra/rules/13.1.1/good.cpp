// Nothing here may be flagged.
struct Base {};
struct Derived : Base {};
