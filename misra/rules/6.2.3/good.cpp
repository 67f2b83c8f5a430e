// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file: an overload, a declaration and its one definition.
namespace places {
inline int thrice(const int value) { return 3 * value; }
inline long thrice(const long value) { return 3 * value; }
int fourfold(int value);
int fourfold(const int value) { return 4 * value; }
}  // namespace places
