// Nothing here may be flagged.
static_assert(sizeof(int) == 4U);
void check();
