// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
void operator delete(void* place) noexcept;  // flagged
