#include "tamis/options.hpp"
#include "tamis/tamis.h"

const char* tamis_version(void) { return TAMIS_VERSION; }

int tamis_has_threads(void) { return tamis::has_threads() ? 1 : 0; }
