// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
class Base {
  public:
    Base() { start(); }  // flagged
    virtual void start();
};
void make() { const Base base{}; }
