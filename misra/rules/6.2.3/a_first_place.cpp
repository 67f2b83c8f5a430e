// SPDX-License-Identifier: Apache-2.0
// Contains the first definition; bad.cpp repeats it.
namespace places {
inline int twice(const int value) { return 2 * value; }
}  // namespace places
