// Nothing here may be flagged.
struct Base {};
struct One : Base {};
