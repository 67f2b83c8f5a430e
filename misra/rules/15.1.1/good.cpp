// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
class Base {
  public:
    Base() { begin(); }
    void begin();
    virtual void start();
};
void make() { const Base base{}; }
