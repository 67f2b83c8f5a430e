// Nothing here may be flagged.
bool less(const unsigned one, const unsigned other) { return one < other; }
float scaled(const int value) { return static_cast<float>(value) * 2.0F; }
