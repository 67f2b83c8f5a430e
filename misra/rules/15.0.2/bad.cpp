// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
class Handle {
  public:
    Handle(Handle&& other);                  // flagged
    int operator=(const Handle& other);      // flagged
};
