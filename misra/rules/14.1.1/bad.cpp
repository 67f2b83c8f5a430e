// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
class Row {  // flagged
  public:
    int open;

  private:
    int closed;
};
