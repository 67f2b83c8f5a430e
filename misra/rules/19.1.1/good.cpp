// Nothing here may be flagged.
#if defined(HERE)
#endif
int now();
