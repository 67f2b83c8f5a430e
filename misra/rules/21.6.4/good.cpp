// Nothing here may be flagged.
void drop(void* place) noexcept;
