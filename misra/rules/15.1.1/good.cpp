// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
class Base {
  public:
    Base() { begin(); }
    void begin();
    virtual void start();
};
void make() { const Base base{}; }
