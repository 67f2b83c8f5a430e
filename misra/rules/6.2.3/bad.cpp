// Repeats, word for word, what another file implements.
namespace places {
inline int twice(const int value) { return 2 * value; }  // flagged
}  // namespace places
