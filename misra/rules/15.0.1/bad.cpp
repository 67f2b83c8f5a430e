// Each marked line must be flagged.
class Handle {  // flagged
  public:
    ~Handle();
    Handle(const Handle& other);
};
