// Each marked line must be flagged.
#if 0
#include "sub\dir.hpp"  // flagged
#endif
int now();
