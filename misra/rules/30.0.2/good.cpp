// Nothing here may be flagged.
void both(int stream);
