// Each marked line must be flagged.
class Row {  // flagged
  public:
    int open;

  private:
    int closed;
};
