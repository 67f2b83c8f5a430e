// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
class Handle {
  public:
    Handle(Handle&& other) noexcept;
    Handle& operator=(const Handle& other);
};
