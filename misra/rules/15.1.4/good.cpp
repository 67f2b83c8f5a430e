// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
class Row {
  public:
    Row() {}
    int read() const { return first; }

  private:
    int first{0};
};
