// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
template <typename T>
int size(T value);
template <>  // flagged
int size<int>(int value);
