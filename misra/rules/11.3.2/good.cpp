// Nothing here may be flagged.
int read(const int** place);
