// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
class Handle {
  public:
    Handle(Handle&& other);                  // flagged
    int operator=(const Handle& other);      // flagged
};
