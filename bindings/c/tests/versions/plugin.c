/* A library that uses libtamis_c: of one version or the other. */
const char* tamis_version(void);
const char* version_of(void);
const char* version_of(void) { return tamis_version(); }
