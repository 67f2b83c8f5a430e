// Each marked line must be flagged.
enum class Colour { red };  // flagged
