// Each marked line must be flagged.
void operator delete(void* place) noexcept;  // flagged
