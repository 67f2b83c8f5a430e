// Each marked line must be flagged.
struct Base {};
struct Derived : virtual Base {};  // flagged
