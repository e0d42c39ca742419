#include "tamis/tamis.h"

const char* tamis_version(void) { return TAMIS_VERSION; }
