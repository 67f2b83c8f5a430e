// Nothing here may be flagged.
#include <cstddef>
std::size_t place() { return sizeof(int); }
