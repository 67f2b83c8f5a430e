// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
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
