// Nothing here may be flagged.
#include <cstdint>
std::int32_t count();
