// Nothing here may be flagged.
int free_name();
