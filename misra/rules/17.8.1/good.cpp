// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
template <typename T>
int size(T value);
int size(int value);
