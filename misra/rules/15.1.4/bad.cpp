// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
class Row {
  public:
    Row() {}  // flagged
    int read() const { return first; }

  private:
    int first;
};
