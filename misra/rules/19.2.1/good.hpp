// Nothing here may be flagged.
#ifndef GOOD_HPP
#define GOOD_HPP
int now();
#endif
