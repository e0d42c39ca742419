/* A program whose two plugins use two versions of libtamis_c: each gets its own. */
#include <stdio.h>
#include <string.h>

const char* version_of_this(void);
const char* version_of_other(void);

int main(void) {
  printf("%s and %s\n", version_of_this(), version_of_other());
  return strcmp(version_of_this(), TAMIS_VERSION) != 0 || strcmp(version_of_other(), "99.0.0") != 0;
}
