// Nothing here may be flagged.
#include <cstddef>
std::size_t now();
