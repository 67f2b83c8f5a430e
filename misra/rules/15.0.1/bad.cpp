// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
class Handle {  // flagged
  public:
    ~Handle();
    Handle(const Handle& other);
};
