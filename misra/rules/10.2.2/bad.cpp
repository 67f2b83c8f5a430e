// Each marked line must be flagged.
enum Colour : unsigned char { red };  // flagged
