/* Stands for libtamis_c of another version. */
const char* tamis_version(void);
const char* tamis_version(void) { return "99.0.0"; }
