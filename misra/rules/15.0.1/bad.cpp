// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
class Handle {  // flagged
  public:
    ~Handle();
    Handle(const Handle& other);
};
