// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
class Row {
  public:
    Row() {}  // flagged
    int read() const { return first; }

  private:
    int first;
};
