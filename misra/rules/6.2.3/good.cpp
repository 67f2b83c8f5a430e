// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged: an overload, a declaration and its one definition.
namespace places {
inline int thrice(const int value) { return 3 * value; }
inline long thrice(const long value) { return 3 * value; }
int fourfold(int value);
int fourfold(const int value) { return 4 * value; }
}  // namespace places
