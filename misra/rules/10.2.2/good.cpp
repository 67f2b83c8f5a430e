// Nothing here may be flagged.
enum class Colour : unsigned char { red };
