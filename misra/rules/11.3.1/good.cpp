// Nothing here may be flagged.
#include <array>
std::array<int, 3> row;
