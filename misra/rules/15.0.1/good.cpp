// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
class Handle {
  public:
    ~Handle();
    Handle(const Handle& other) = delete;
    Handle(Handle&& other) = delete;
    Handle& operator=(const Handle& other) = delete;
    Handle& operator=(Handle&& other) = delete;
};
