// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
class Base {
  public:
    Base() { start(); }  // flagged
    virtual void start();
};
void make() { const Base base{}; }
