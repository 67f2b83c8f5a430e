// Each marked line must be flagged.
class Handle {
  public:
    Handle(Handle&& other);                  // flagged
    int operator=(const Handle& other);      // flagged
};
