// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
template <typename T>
int size(T value);
template <>  // flagged
int size<int>(int value);
